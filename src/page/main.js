// SPDX-License-Identifier: MIT
/* The page: its three parts, of which one is shown. */
import { bindJudge } from '../npm/bind_judge.js';
import { $, isCommand, moduleOf, readHash } from './base.js';
import { startDraw } from './draw.js';
import { startJudge } from './judge.js';
import { startSee } from './see.js';

const PARTS = ['see', 'judge', 'draw'];

const judgeModule = await moduleOf('judge.wasm');
const library = bindJudge(judgeModule);
const judge = startJudge(library, judgeModule);
const see = startSee(library, judgeModule, judge.code);
const parts = { see, judge, draw: startDraw(library) };

function show(part, said = {}) {
    for (const name of PARTS) {
        $(name).hidden = name !== part;
        $(`tab-${name}`).setAttribute('aria-selected', String(name === part));
        $(`tab-${name}`).tabIndex = name === part ? 0 : -1;
    }
    return parts[part].open(said);
}

function choose(part) {
    show(part);
    history.replaceState(null, '', parts[part].hash());
}

function moveTab(event) {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!by || isCommand(event))
        return;
    const at = PARTS.indexOf(event.currentTarget.id.slice(4));
    const to = PARTS[(at + by + PARTS.length) % PARTS.length];
    event.preventDefault();
    choose(to);
    $(`tab-${to}`).focus();
}

for (const part of PARTS) {
    $(`tab-${part}`).addEventListener('click', () => choose(part));
    $(`tab-${part}`).addEventListener('keydown', moveTab);
}

function openAddress() {
    const { part, said } = readHash();
    return show(PARTS.includes(part) ? part : 'see', said);
}

addEventListener('hashchange', openAddress);
await openAddress();
