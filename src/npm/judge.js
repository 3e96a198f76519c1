// SPDX-License-Identifier: MIT
import { bindJudge } from './bind_judge.js';
import { load } from './load.js';

export const {
    regimes, margins, applies, cases, caseLine, answerLine, readCase, judge,
} = bindJudge(await load('judge.wasm'));
