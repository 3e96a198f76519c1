// SPDX-License-Identifier: MIT

/* Time against wrong decisions: a point a candidate, both by powers of ten. The drawing is as wide
 * as a phone, so that its letters are legible there. */

const PLANE = {width: 360, height: 268, left: 52, right: 350, top: 10, bottom: 196, none: 216,
    floor: 228};

/* The powers of ten at the ends: the same for every shape, so that planes can be compared. */
function powersOf(numbers, low, high) {
    const powers = numbers.filter(number => number > 0).map(Math.log10);
    return [Math.min(low, ...powers.map(Math.floor)), Math.max(high, ...powers.map(Math.ceil))];
}
const between = ([low, high], number, from, to) =>
    from + (Math.log10(number) - low) / (high - low) * (to - from);

const TURNS = [0, 180, 45, -45, 135, -135, 90, -90, 20, -20, 160, -160, 70, -70, 110, -110];
const overlap = (a, b) => Math.min(a.x1, b.x1) > Math.max(a.x0, b.x0) &&
    Math.min(a.y1, b.y1) > Math.max(a.y0, b.y0);
const around = mark => ({x0: mark.x - 5, y0: mark.y - 5, x1: mark.x + 5, y1: mark.y + 5});
const away = (box, mark) => Math.hypot(Math.max(box.x0 - mark.x, mark.x - box.x1, 0),
    Math.max(box.y0 - mark.y, mark.y - box.y1, 0));

/* Puts the name where it covers nothing, as near as there is room. A line leads to it from a point
 * that is not the nearest one or is far. */
function place(mark, marks) {
    const half = 3.4 * mark.name.length + 1;
    for (let distance = 7; distance < 160; distance += 3) {
        for (const turn of TURNS) {
            const reach = distance + (turn % 180 ? 4 : 0), angle = turn * Math.PI / 180;
            const x = mark.x + Math.cos(angle) * (reach + half);
            const y = mark.y - Math.sin(angle) * reach;
            const box = {x0: x - half, y0: y - 5.5, x1: x + half, y1: y + 5.5};
            const others = marks.filter(other => other !== mark);
            mark.led = distance >= 14;
            if (box.x0 > PLANE.left && box.x1 < PLANE.width && box.y0 > 1 &&
                box.y1 < PLANE.floor - 1 && !marks.some(other => overlap(box, around(other)) ||
                    (other.box && overlap(box, other.box))) &&
                others.every(other => away(box, other) > (mark.led ? 9 : away(box, mark)))) {
                mark.box = box;
                return;
            }
        }
    }
    mark.led = false;
    mark.box = {x0: mark.x + 7, y0: mark.y - 5.5, x1: mark.x + 7 + 2 * half, y1: mark.y + 5.5};
}

function drawMark({who, name, sum, x, y, box, led}) {
    const middle = (box.x0 + box.x1) / 2, height = (box.y0 + box.y1) / 2;
    const made = drawing('g', {class: who.library ? 'peer' : 'tier'}, drawing('title', {},
        `${name}: ${time(sum.time)} a ray; wrong decisions` +
        `${sum.wrong ? ' per million' : ''}: ${perMillion(sum)}`));
    if (led)
        made.append(drawing('path', {class: 'lead',
            d: `M${x} ${y}L${Math.min(Math.max(x, box.x0), box.x1)} ${height}`}));
    made.append(who.library
        ? drawing('path', {class: 'dot', d: `M${x} ${y - 4.5}l4.5 4.5l-4.5 4.5l-4.5 -4.5z`})
        : drawing('circle', {class: 'dot', cx: x, cy: y, r: 4}),
    drawing('text', {class: 'name', x: middle, y: height + 3.6, 'text-anchor': 'middle'}, name));
    return made;
}

function drawAxes(svg, times, wrongs) {
    const {left, right, top, bottom, none, floor} = PLANE;
    const text = (x, y, anchor, words) =>
        svg.append(drawing('text', {x, y, 'text-anchor': anchor}, words));
    const line = (d, kind = 'grid') => svg.append(drawing('path', {class: kind, d}));
    for (let power = times[0]; power <= times[1]; power++) {
        const x = between(times, 10 ** power, left, right);
        const unit = ['ns', 'µs', 'ms', 's'][Math.trunc(power / 3)];
        line(`M${x} ${top}V${floor}`);
        text(x, floor + 14, power === times[1] ? 'end' : 'middle', 10 ** (power % 3) + ' ' + unit);
    }
    for (let power = wrongs[0]; power <= wrongs[1]; power++) {
        const y = between(wrongs, 10 ** power, bottom, top);
        line(`M${left} ${y}H${right}`);
        text(left - 5, y + 3.5, 'end', power < 4 ? String(10 ** power) : '10' + raised(power));
    }
    line(`M${left} ${none}H${right}`, 'none');
    text(left - 5, none + 3.5, 'end', 'none');
    text((left + right) / 2, floor + 32, 'middle', 'processor time a ray');
    svg.append(drawing('text', {'text-anchor': 'middle',
        transform: `translate(10 ${(top + bottom) / 2}) rotate(-90)`}, 'wrong per million'));
}

function planeOf(shape, part) {
    const {width, height, left, right, top, bottom, none} = PLANE;
    const sums = report.candidates.flatMap(who => shapes.map(one => sumOf(who, one, part)))
        .filter(sum => sum);
    const times = powersOf(sums.map(sum => sum.time), 1, 3);
    const wrongs = powersOf(sums.map(sum => sum.share * 1e6), 5, 6);
    const svg = drawing('svg', {class: 'plane', viewBox: `0 0 ${width} ${height}`, role: 'img',
        'aria-label': `Time a ray against wrong decisions: ${shape}`});
    const marks = answering(shape).map(who => ({who, sum: sumOf(who, shape, part),
        name: nameOf(who) + (isMeasure(who) ? ' (the measure)' : '')}))
        .filter(mark => mark.sum && mark.sum.time > 0);
    for (const mark of marks) {
        const {sum} = mark;
        mark.x = between(times, sum.time, left, right);
        mark.y = sum.wrong ? between(wrongs, sum.share * 1e6, bottom, top) : none;
    }
    marks.forEach(mark => place(mark, marks));
    drawAxes(svg, times, wrongs);
    svg.append(...marks.map(drawMark));
    return svg;
}

function planes(shape) {
    const titles = ['Rays of pictures: time and wrong decisions',
        'The hard regimes: time and wrong decisions'];
    const notes = ['● surehit’s tiers, ◇ other routines. Time: of hits alone, all asked the same ' +
        'cases in turns.', 'Wrong: the mean over the regimes (for a routine in float: over those ' +
        'that floats can say). Time: the median regime’s; the slowest is in the table below.'];
    const parts = [0, 1].filter(part => answering(shape).some(who => sumOf(who, shape, part)));
    return element('div', {class: 'columns two'}, ...parts.map(part =>
        element('div', {}, h3(titles[part]), planeOf(shape, part), soft(notes[part]))));
}

/* Regimes by candidates. */

function key(...text) {
    const made = element('p', {class: 'key'});
    ['0', '≤ 0.1', '≤ 1', '≤ 5', '≤ 20', 'more'].forEach((label, i) =>
        made.append(element('span', {class: 'h' + i}, label), ' '));
    made.append(...text);
    return made;
}

function heatCell(who, row) {
    if (!row)
        return cell('', {class: 'h0'});
    const share = row.valid ? row.wrong / row.valid : 0, made = shareCell(who, share);
    if (endOf(row))
        made.textContent = ends[endOf(row)];
    else if (row.breaches + row.unasked > 0)
        made.append('†');
    if (row.breaches + row.unasked > 0)
        made.title = `${percent(share)} %; ` + Object.entries(row.faults).map(([name, number]) =>
            `${name} ${count(number)}`).join(', ') + `; given up, not asked ${count(row.unasked)}`;
    return made;
}

function heatMap(shape) {
    const asked = answering(shape);
    const turned = name => element('th', {class: 'turned', scope: 'col'},
        element('span', {}, name));
    const rows = report.regimes.filter(({name}) =>
        asked.some(who => rowsOf(who, shape).some(row => row.regime === name)));
    return table('Wrong decisions by regime: ' + shape, 'heat', [[head('regime'), turned('cases'), ...asked.map(who =>
        turned(nameOf(who)))]], rows.map(({name, cases}) =>
        named(name, cell(count(cases), {class: 'cases'}), ...asked.map(who =>
            heatCell(who, rowsOf(who, shape).find(row => row.regime === name))))));
}

function heatNotes() {
    let marks = ' per cent of the valid cases; empty: floats can’t say such numbers';
    if (isHeld('reference'))
        marks += `; certain and exact, held against CGAL: ${report.reference_cases} times as ` +
            'many cases';
    if (isHeld('like'))
        marks += '; * held against exact, = itself: no independent evidence';
    return [key(marks), soft('† : and breaches of the contract. crash, hang, lost: a case made the ' +
        'routine crash, take too long, or end without an answer, and such cases are wrong.')];
}

/* How far off t is: the shares of hits by powers of two of the error. A small share must be seen
 * beside a large one: heights grow with its root. */

function histograms(shape) {
    const asked = answering(shape), each = 34, right = 356, bottom = asked.length * each;
    const left = Math.min(right / 2,
        Math.max(60, ...asked.map(who => 6.1 * nameOf(who).length + 8)));
    const svg = drawing('svg', {class: 'histogram', viewBox: `0 0 360 ${bottom + 30}`, role: 'img',
        'aria-label': `Errors of t: ${shape}`});
    const step = (right - left) / asked[0].rows[0].t_ulps.by_powers_of_two.length;
    const middle = (text, x, y) =>
        svg.append(drawing('text', {x, y, 'text-anchor': 'middle'}, text));
    for (const power of [null, 8, 16, 24, 32, 40, 48, 56, 63]) {
        const x = left + step * (power === null ? 0.5 : power + 1.5);
        svg.append(drawing('path', {class: 'grid', d: `M${x} 0V${bottom}`}));
        middle(power === null ? '0' : '2' + raised(power), x, bottom + 12);
    }
    middle('error of t, in ulps', (left + right) / 2, bottom + 27);
    asked.forEach((who, i) => {
        const y = i * each + each / 2;
        svg.append(drawing('text', {class: 'name', x: left - 6, y: y + 3.6, 'text-anchor': 'end'},
            nameOf(who)), drawing('path', {class: 'grid', d: `M${left} ${y}H${right}`}));
        [0, 1].forEach(part => {
            const sum = sumOf(who, shape, part);
            const bars = sum && sum.hits ? sum.classes.map(hits => 15 * Math.sqrt(hits / sum.hits))
                : [];
            svg.append(drawing('path', {class: part ? 'hard' : 'camera', d: bars.map((high, n) =>
                high ? `M${left + n * step} ${y}v${part ? high : -high}h${step - 0.5}V${y}z` : '')
                .join('')}));
        });
    });
    return svg;
}

/* The same as numbers. */

function figures(shape) {
    const sums = (who, sum, slowest) => !sum ? Array(2 + slowest).fill('–')
        : [isMeasure(who) ? '=' : perMillion(sum), marked(who, sum.time),
            ...slowest ? [marked(who, sum.slowest)] : []];
    const sizes = (of, written) => ['median', '99', 'most'].map(key =>
        of && of.hits ? written(of[key]) : '–');
    const cells = who => {
        const [camera, hard] = [sumOf(who, shape, 0), sumOf(who, shape, 1)];
        return [...sums(who, camera, 0), ...sums(who, hard, 1),
            count(add([camera, hard], sum => sum ? sum.breaches : 0))];
    };
    const errors = who => {
        const of = rowsOf(who, shape).find(row => row.regime === 'camera') || {};
        const t = of.t_ulps;
        return [...sizes(t, ulps), t && t.hits ? percent(t.correctly_rounded / t.hits) : '–',
            ...sizes(of.t_pixels, length), ...sizes(of.t_extents, length)];
    };
    const rows = cells => answering(shape).map(who =>
        named(nameOf(who), ...cells(who).map(text => cell(text))));
    const heads = ['median', '99 %', 'largest'];
    return [h3('In figures'), table('In figures: ' + shape, '', [
        [head(''), group('rays of pictures', 2), group('hard regimes', 3), group('all', 1)],
        ['routine', 'wrong per million', 'time', 'wrong per million', 'time, median', 'slowest',
            'breaches'].map(name => head(name)),
    ], rows(cells)),
    soft('Breaches of the contract: a NaN, t outside its interval, invalid input accepted, ' +
        'outputs touched on a miss, a changing answer, a leak, a crash, no answer.'),
    h3('How far off t is, in pictures'), table('How far off t is: ' + shape, 'lengths', [
        [head(''), group('ulps', 4), group('pixels', 3), group('size of the scene', 3)],
        ['routine', ...heads, 'rightly rounded, %', ...heads, ...heads].map(name => head(name)),
    ], rows(errors)),
    soft('Errors of t where the hit is right. In ulps: how many doubles (floats, for a routine ' +
        'in float) lie between the answer and the rightly rounded one. In pixels: as a length, ' +
        'over what a pixel covers at the hit. Of the scene: that length over the diagonal of ' +
        'the box around the eye and all objects that end.')];
}

function shapePart(shape) {
    const here = section(shape, shape);
    here.classList.add('shape');
    const errors = soft('Shares of the hits by size of the error: ',
        element('b', {class: 'camera'}, 'rays of pictures upwards'), ', ',
        element('b', {class: 'hard'}, 'hard regimes downwards'),
        '. Heights grow with the root of the share: 1 % is a tenth of the full height.');
    here.append(planes(shape), element('div', {class: 'columns wide'},
        element('div', {}, h3('Wrong decisions by regime, %'), heatMap(shape), ...heatNotes()),
        element('div', {}, h3('How far off t is, where the hit is right'), histograms(shape),
            errors)), ...figures(shape), ...marginTable(shape), ...worstCases(shape));
}

/* How it was measured. */

function askedRow(who) {
    const left = text => cell(text, {class: 'left'});
    const {name, version, build} = who.says;
    const about = [[name, version].filter(word => word).join(' '), build].filter(word => word)
        .join(', ') || candidates[who.name] || '';
    if (who.trouble)
        return named(nameOf(who), left(about), cell('–'), cell('–'), cell('–'),
            left('not asked: ' + who.trouble));
    const truth = who.truth === 'reference' ? 'CGAL' : who.truth === 'exact' ? 'exact'
        : (isMeasure(who) ? 'itself' : 'exact') + ': no independent evidence';
    return named(nameOf(who), left(about), left(who.in_float ? 'float' : 'double'), left(truth),
        cell(count(add(who.rows, row => row.cases))),
        left(optionsOf(who)));
}

/* The words that ask one cell of the page again; none where nobody was asked. */
function cellCommand() {
    const who = report.candidates.find(who => who.rows.length > 0);
    if (!who)
        return '';
    const {shape, regime} = who.rows[Math.min(1, who.rows.length - 1)];
    const times = who.truth === 'reference' ? report.reference_cases : 1;
    return `\n${report.program} judge ${optionsOf(who)} --shape ${shape} --regime ${regime}` +
        ` --count ${times * casesOf(regime)} --seed ${report.seed}`;
}

function how() {
    const here = section('how', 'How it was measured', 'how it was measured');
    here.append(element('p', {}, bold('Cases'), `: ${count(report.count)} of each shape and ` +
        `regime; ${count(casesOf('camera'))} in camera; ${count(casesOf('bits'))} in bits and ` +
        'degenerate, whose exact answer may take milliseconds.' + (isHeld('reference')
        ? ` ${report.reference_cases} times as many for certain and exact, the others’ among them.`
        : '') + ' All are made from the seed, the same on every machine; docs/regimes.md says ' +
        'how.'),
    element('details', {}, element('summary', {}, 'What the regimes are'), element('dl', {},
        ...report.regimes.flatMap(({name}) => [element('dt', {}, name),
            element('dd', {}, regimes[name] || '')]))),
    element('p', {}, bold('Right answers'), ': the exact tier’s, and for certain and exact ' +
        'themselves CGAL’s, which the table below says of each routine; inputs are exact ' +
        'numbers, solids are closed, a touch is a hit (docs/contract.md). Wrong is a false hit, ' +
        'a false miss, a wrong part, a valid case refused, or no answer, in the share of the ' +
        'valid cases. “None in N” leaves room: with 95 % confidence the true share is below ' +
        '3.84 / (N + 3.84).'),
    element('p', {}, bold('Time'), ': processor time of one thread for hits alone, without ' +
        'normals. Tiers and other routines are called alike, one ray at a time, each in a ' +
        'process of its own, and take turns at the same cases: five rounds, in an order that ' +
        'changes, of which the median counts; of each the faster of two passes. Nothing else is ' +
        'judged meanwhile.'),
    h3('Who was asked, and held against what'), table('Who was asked', '', [['routine', 'what it is',
        'computes in', 'held against', 'in cases', 'surehit judge …'].map(name => head(name))],
    report.candidates.map(askedRow)), h3('Again'),
    element('p', {}, 'This page, and any one cell of it:'), element('pre', {}, report.command +
        cellCommand()),
    soft(`${report.cpu}; ${report.compiler} ${report.flags}; ${report.seconds.toFixed(0)} s of ` +
        `judging. surehit ${report.version}, ${report.date}.`));
}

/* The page. */

function introduce() {
    const asked = add(report.candidates, who => add(who.rows, row => row.cases));
    const several = report.candidates.length;
    document.getElementById('asked').append(`${several} routine${several === 1 ? '' : 's'}, ` +
        `asked ${count(asked)} questions whose right answer is known exactly: how often is each ` +
        'wrong, where, by how much, and what does it cost?');
    document.getElementById('cases').append(
        `${count(casesOf('camera'))} rays of pictures a surface, and ` +
        `${count(report.count)} of each of the hard kinds (regimes): ` +
        'grazing, far, huge, tiny, at rims, inside and so on. The same cases for everyone' +
        (isHeld('reference') ? ', and more for certain and exact' : '') + '; a routine that ' +
        'computes in float is asked cases whose numbers are floats. surehit ' +
        `${report.version}, seed ${report.seed}, ${report.date}.`);
}

introduce();
ordinary();
glance();
album();
shapes.forEach(shapePart);
blocks();
how();
/* What scrolls and goes on is marked at its edge. */
function markCut() {
    for (const one of document.querySelectorAll('.box'))
        one.classList.toggle('cut', one.scrollWidth > one.clientWidth + 1);
}
addEventListener('load', markCut);
addEventListener('resize', markCut);
document.addEventListener('toggle', markCut, true);
markCut();
if (location.hash)
    location.replace(location.hash);
