// SPDX-License-Identifier: MIT
import { bind, instance } from './bind.js';
import { load } from './load.js';

export const {
    shapes, tiers, statuses, parts, hit, hits, occluded, interval, check, stage,
} = bind(instance(await load('surehit.wasm')));
