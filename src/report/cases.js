// SPDX-License-Identifier: MIT
/* Cases to start from: of each routine the worst of each kind, and how far wrong decisions are from
 * right. */

const ends = {crash: 'crash', 'no answer in time': 'hang', 'no answer': 'lost'};
const endOf = row => Object.keys(ends).find(name => row.faults[name]);

/* A word as a shell reads it. */
function shellWord(word) {
    return /^[\w./=:,+-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`;
}

function optionsOf(who) {
    return (who.library ? '--candidate ' + shellWord(who.library) : '--tier ' + who.tier) +
        (who.truth === 'reference' ? ' --truth reference' : '');
}

function wrongBy(one) {
    return one.ulps !== undefined ? (one.ulps === null ? '∞' : one.ulps.toPrecision(6) * 1) + ' ulps'
        : one.margin ? one.margin.toPrecision(3) * 1 + ' of its size' : '–';
}

function worstOf(who, list) {
    const left = text => cell(text, {class: 'left'});
    return element('details', {class: 'worst'},
        element('summary', {}, bold(nameOf(who)), ': ' + list.map(one => one.kind).join(', ')),
        table('Worst cases of ' + nameOf(who), '', [['kind', 'regime', 'in the case', 'wrong by',
            'answer', 'right'].map(name => head(name, {scope: 'col', class: 'left'}))],
        list.map(one => named(one.kind, ...[one.regime, one.event || '–', wrongBy(one),
            one.answer, one.right].map(left)))),
        element('pre', {}, list.map(one => `echo '${one.case} # ${one.regime}' | ` +
            `${report.program} judge --cases - ${optionsOf(who)}`).join('\n')));
}

function worstCases(shape) {
    const found = answering(shape).map(who =>
        [who, who.worst.filter(one => one.shape === shape)]).filter(([, list]) => list.length);
    return !found.length ? [] : [h3('Cases to start from'),
        element('p', {}, 'Of each routine the worst case of each kind, made simple: what it answers, ' +
            'what is right, and a line that asks it again.'),
        ...found.map(([who, list]) => worstOf(who, list))];
}

/* Sums over all regimes. */
function marginRow(who, rows, events, sizes) {
    const valid = add(rows, row => row.valid);
    const wrong = rows.filter(row => row.margins);
    const beyond = i => add(wrong, row => row.margins.wrong[i].wrong) / (valid || 1);
    return [...events.map(name => count(add(wrong, row => row.decisions.wrong[name]))),
        ...sizes.map((_, i) => percent(beyond(i))),
        length(Math.max(0, ...wrong.map(row => row.margins.most)))];
}

function marginTable(shape) {
    const wrong = answering(shape).flatMap(who => rowsOf(who, shape)).filter(row => row.margins);
    if (!wrong.length)
        return [];
    const events = Object.keys(wrong[0].decisions.wrong);
    const sizes = wrong[0].margins.wrong.map(one => one.beyond);
    return [h3('What is wrong, and by how much'), table('Margins: ' + shape, 'margins', [
        [head(''), group('wrong decisions by what happens in the case', events.length),
            group('wrong by more than so much of the object’s size, %', sizes.length), head('')],
        ['routine', ...events, ...sizes.map(size => size.toExponential(0)), 'most']
            .map(name => head(name)),
    ], answering(shape).map(who => named(nameOf(who), ...marginRow(who, rowsOf(who, shape), events,
        sizes).map(text => cell(isMeasure(who) ? '=' : text))))),
    soft('Over all regimes. Conventions differ where a ray starts on the surface or inside, hits ' +
        'at the end of its range alone, touches, or where two parts tie; clear is none of them. By ' +
        'how much: so far all faces of the object may move, outwards or inwards, and the answer is ' +
        'wrong still (docs/judge.md, “Margins”).')];
}
