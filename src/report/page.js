// SPDX-License-Identifier: MIT
/* Draws the report out of its JSON document (docs/report.md). */
'use strict';
const report = JSON.parse(document.getElementById('report').textContent);
const main = document.querySelector('main'), nav = document.querySelector('nav');
const rowsOf = (who, shape) => who.rows.filter(row => row.shape === shape);
const answering = shape => report.candidates.filter(who => rowsOf(who, shape).length > 0);
const shapes = report.shapes.filter(shape => answering(shape).length > 0);

/* What each stands for, in a line; docs/regimes.md has more of the regimes. */
const candidates = {
    float32: 'the notes’ formulas in single precision, as shaders and games do',
    textbook: 'the notes’ formulas in double, as they stand',
    stable: 'the best that plain double can do',
    certain: 'every decision right, t within a bound that is told',
    exact: 'every decision right, t and normal correctly rounded',
    embree: 'Embree 3, one ray at a time, its robust mode',
    epsilon: 'absolute epsilons, as in most tutorials',
    gems_cylinder: 'the capped cylinder of Graphics Gems IV',
    interval: 'pbrt’s: a hit is rejected unless its whole interval is one',
    kahan: 'Kahan’s discriminant and Vieta’s second root',
    perpendicular_double: 'the sphere of Ray Tracing Gems, chapter 7, in double',
    perpendicular_float: 'the sphere of Ray Tracing Gems, chapter 7, in float',
    textbook_float: 'the books’ formulas in single precision',
};
const regimes = {
    camera: 'the rays of twelve pictures and what a hierarchy asks of them',
    typical: 'nothing in particular: sizes and distances over six powers of ten',
    grazing: 'rays that pass within 10⁻² to 10⁻¹⁶ of touching',
    tangent: 'rays that touch exactly',
    neighbour: 'exact touches with one number moved by its last bits',
    far: 'objects 10³ to 10¹⁵ times their size away',
    huge: 'coordinates up to 10³⁰⁰: products overflow',
    tiny: 'numbers so small that products underflow',
    inside: 'rays that start inside the solid',
    on_surface: 'rays that start on the surface, as shadow rays do',
    rim: 'through an edge or just beside it',
    apex: 'through a cone’s tip or just beside it',
    axis_parallel: 'along the axis, exactly and nearly',
    wall_parallel: 'along a cone’s wall, exactly and nearly',
    edge_on: 'in the plane of a disc or cap, exactly and nearly',
    needle: 'a million million times as high as wide',
    coin: 'a million million times as wide as high',
    degenerate: 'radius 0, zeros of either sign, and invalid input',
    interval: 't_min or t_max at the hit or one bit beside it',
    midpoint: 't halfway between two doubles; ranges that end beside it',
    nonunit: 'directions, normals and axes of length 10⁻¹⁵⁰ to 10¹⁵⁰',
    integers: 'a small world of whole numbers, everything degenerate at once',
    bits: 'all exponents and bit patterns, infinities and NaN among them',
    off_surface: 'rays that start one bit off the surface, as shadow rays do',
    nearly_parallel: 'a step through a face, or aside of the axis, for up to 2³⁰ along it',
    far_tangent: 'exact touches from up to 2⁴⁵ away, and one bit beside',
    scaled_neighbour: 'exact touches and their neighbours, at 10³⁰⁰ and 10⁻²⁸⁸',
    scales: 'short whole vectors, each times a length of its own: what cancels does so to the last bit',
};
const pictures = {
    ball: ['A ball of radius 1, thirty million away', 'It fills the frame of a very long lens. ' +
        'The square of the distance is near 10¹⁵: beside it, a float (7 digits) does not see the ' +
        'radius at all, and a double (16 digits) keeps one digit of it, unless the formula takes ' +
        'the two apart first.'],
    'cylinder and cone': ['A cylinder and a cone, ten million away', 'The same with more terms ' +
        'that cancel. Speckles are rays that miss what they should hit.'],
};

/* Elements. A child is an element or text. */

function fill(at, attributes, children) {
    for (const [name, value] of Object.entries(attributes))
        at.setAttribute(name, value);
    at.append(...children);
    return at;
}
const element = (tag, attributes = {}, ...children) =>
    fill(document.createElement(tag), attributes, children);
const drawing = (tag, attributes = {}, ...children) =>
    fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
const soft = (...text) => element('p', {class: 'soft'}, ...text);
const h3 = text => element('h3', {}, text);
const bold = text => element('b', {}, text);
const head = (text, attributes = {scope: 'col'}) => element('th', attributes, text);
const group = (text, columns) =>
    head(text, {class: 'group', scope: 'colgroup', colspan: columns});
const cell = (text, attributes = {}) => element('td', attributes, text);
const row = cells => element('tr', {}, ...cells);
const box = (title, content) => element('div',
    {class: 'box', tabindex: 0, role: 'region', 'aria-label': title}, content);
const table = (title, kind, heads, rows) => box(title,
    element('table', {class: kind}, element('thead', {}, ...heads.map(row)),
        element('tbody', {}, ...rows)));
const named = (name, ...cells) =>
    row([element('th', {scope: 'row', title: name}, name), ...cells]);

function section(id, title, link = id) {
    nav.append(element('a', {href: '#' + id}, link));
    const made = element('section', {id}, element('h2', {}, title));
    main.append(made);
    return made;
}

/* Numbers as people write them. */

const count = number => number.toLocaleString('en-US');
const digits = number => number.toFixed(number < 10 ? 1 : 0);
const time = ns => !ns ? '–' : ns < 999.5 ? digits(ns) + ' ns'
    : ns < 999.5e3 ? digits(ns / 1e3) + ' µs' : digits(ns / 1e6) + ' ms';
const raised = power => [...String(power)].map(digit => '⁰¹²³⁴⁵⁶⁷⁸⁹'[digit]).join('');
const ulps = number => number === null ? '∞' : number < 10000 ? number.toFixed(0)
    : '10' + raised(Math.round(Math.log10(number)));
const length = number => number === null ? '∞' : number === 0 ? '0'
    : number < 1e-3 ? number.toExponential(1) : number.toPrecision(2);
const instructions = number => number ? number.toFixed(0) : '–';
function percent(share) {
    const of100 = 100 * share;
    return share === 0 ? '0' : of100 < 0.005 ? '<0.01'
        : of100.toFixed(of100 < 0.995 ? 2 : of100 < 9.95 ? 1 : 0);
}
const perMillion = sum => sum.wrong === 0 ? 'none in ' + count(sum.valid)
    : sum.share * 1e6 < 9.95 ? (sum.share * 1e6).toFixed(1) : count(Math.round(sum.share * 1e6));
const heat = share => 'h' + [0, 1e-3, 1e-2, 5e-2, 0.2].filter(most => share > most).length;

/* Who was asked. */

const usual = ['camera', 'typical']; // all other regimes are hard
const isMeasure = who => who.truth === 'like' && who.tier === 'exact';
const nameOf = who => who.name + (who.truth === 'like' ? '*' : '');
const isHeld = against => report.candidates.some(who => who.truth === against);
const casesOf = regime => report.regimes.find(one => one.name === regime).cases;
const marked = (who, ns) => time(ns) + (ns && who.with_normals ? 'ⁿ' : '');
const add = (list, value) => list.reduce((sum, one) => sum + value(one), 0);

function median(list) {
    const sorted = list.filter(one => one).sort((a, b) => a - b), n = sorted.length;
    return n ? (sorted[(n - 1) >> 1] + sorted[n >> 1]) / 2 : 0;
}

/* The rays of pictures, or the hard regimes: each of these has the same weight, whatever its number
 * of cases. null: not asked. */
function sumOf(who, shape, part) {
    const rows = rowsOf(who, shape).filter(row =>
        part === 0 ? row.regime === 'camera' : !usual.includes(row.regime));
    if (!rows.length)
        return null;
    const times = rows.map(row => row.nanoseconds);
    return {
        valid: add(rows, row => row.valid), wrong: add(rows, row => row.wrong),
        breaches: add(rows, row => row.breaches), ended: rows.map(endOf).find(end => end),
        share: add(rows, row => row.valid && row.wrong / row.valid) / rows.length,
        instructions: rows[0].instructions, time: median(times), slowest: Math.max(...times),
        hits: add(rows, row => row.t_ulps.hits),
        classes: rows[0].t_ulps.by_powers_of_two.map((_, i) =>
            add(rows, row => row.t_ulps.by_powers_of_two[i])),
    };
}

const shareCell = (who, share) => isMeasure(who) ? cell('=', {class: 'h0'})
    : cell(percent(share), {class: heat(share)});

/* What each tier shows wrong in ordinary frames, and what these take: the project's record, which
 * was measured once (docs/trade.json), with what this report finds at the extremes. */

const titles = {inside: 'eye inside a solid'};

function extremes(tier) {
    const who = report.candidates.find(who => who.tier === tier);
    const sums = who ? shapes.map(shape => sumOf(who, shape, 1)).filter(sum => sum) : [];
    return sums.length ? shareCell(who, add(sums, sum => sum.share) / sums.length) : cell('–');
}

function ordinary() {
    const record = JSON.parse(document.getElementById('trade').textContent);
    const scenes = Object.keys(record.pictures), tiers = Object.keys(record.pictures[scenes[0]]);
    const here = section('trade', 'The trade, in ordinary frames', 'the trade');
    here.append(table('The trade', '', [[head(''), head('extremes: wrong, %'),
        ...scenes.map(name => head(titles[name] || name))]], [
        ...tiers.map(tier => named(tier, extremes(tier), ...scenes.map(name => {
            const {other, step} = record.pictures[name][tier];
            return cell(`${count(other)} · ${step} · ${record.times[name][tier].ratio.toFixed(2)}`);
        }))),
        named('bytes an object', cell(''), ...scenes.map(name => {
            const {objects, object_bytes, hierarchy_bytes} = record.memory[name];
            return cell(`${(object_bytes / objects).toFixed(0)} + ` +
                (hierarchy_bytes / objects).toFixed(0));
        })),
    ]), element('p', {}, 'In each cell: pixels of 921,600 that show another object than exact · ' +
        'the largest step of a colour, of 255 · the time of the frame over textbook’s. In the ' +
        'last line: memory of the objects, with materials and lights, and of the hierarchy. ' +
        'S, M and L are 12, 1,001 and 100,001 objects.'),
    box('Time against wrong pixels', element('img', {src: 'data:image/svg+xml,' +
        encodeURIComponent(document.getElementById('drawn').textContent),
    alt: 'Time against wrong pixels, a panel a scene; the table has the same figures'})),
    soft(`The frames are the project’s record, measured on one core of ${record.cpu} (median of ` +
        `${record.repeats} rounds in turns), and not by this report, which finds what is wrong at ` +
        'the extremes, the mean over surfaces and hard regimes. docs/tracer.md says how.'));
}

/* At a glance. */

function glance() {
    const here = section('glance', 'At a glance', 'at a glance');
    const counted = report.candidates.some(who => who.rows.some(row => row.instructions));
    const groups = ['wrong where it is hard, %', 'time for a ray of a picture',
        ...counted ? ['instructions for it'] : []];
    const wrongCell = (who, sum) => {
        const made = shareCell(who, sum.share);
        if (sum.ended)
            made.append(', ' + ends[sum.ended]);
        return made;
    };
    const cells = who => groups.flatMap((_, i) => shapes.map(shape => {
        const sum = sumOf(who, shape, i ? 0 : 1);
        return !sum ? cell('–') : i === 0 ? wrongCell(who, sum)
            : cell(i === 1 ? marked(who, sum.time) : instructions(sum.instructions));
    }));
    here.append(element('p', {}, 'Left: wrong decisions (hit, miss or part) in the hard ' +
        'regimes, per cent; the mean over the regimes. Right: processor time for an answer to ' +
        'a ray of a picture, without the normal.'), table('At a glance', '', [
        [head(''), ...groups.map(name => group(name, shapes.length))],
        [head('routine'), ...groups.flatMap(() => shapes.map(name => head(name)))],
    ], report.candidates.map(who => named(nameOf(who), ...cells(who)))));
    const note = soft('– : not answered, or not asked. Half of the rays of many regimes hit: ' +
        'guessing is wrong 50 % of the time.');
    if (isHeld('reference'))
        note.append(' ', bold('certain'), ' and ', bold('exact'), ' are held against CGAL, which ' +
            'shares nothing with them; all others against exact.');
    if (isHeld('like'))
        note.append(' * : held against ', bold('exact'), ', that is against itself (=) or its ' +
            'like: no independent evidence. surehit-reference, for which CGAL would be asked, was ' +
            'not found; docs/accuracy.md has what CGAL says of them.');
    if (counted)
        note.append(' Instructions repeat where times don’t: valgrind’s callgrind counts them, ' +
            'over the first 512 rays.');
    if (report.candidates.some(who => who.with_normals))
        note.append(' ⁿ : the normal is in the time, for it is given with every hit.');
    here.append(note);
}

/* Two scenes by each tier, and where they differ from exact. */

const bytesOf = text => Uint8ClampedArray.from(atob(text), letter => letter.charCodeAt(0));

/* `colour` gives the red, green and blue of a pixel. */
function canvasOf(scene, label, colour) {
    const made = element('canvas', {width: scene.width, height: scene.height, role: 'img',
        'aria-label': label});
    const image = new ImageData(scene.width, scene.height);
    for (let i = 0; i < scene.width * scene.height; i++)
        image.data.set([...colour(3 * i), 255], 4 * i);
    made.getContext('2d').putImageData(image, 0, 0);
    return made;
}

/* The colour says how much, from yellow to red; where there is no difference the right picture is
 * pale grey. */
function difference(rgb, right, i) {
    const most = Math.max(...[0, 1, 2].map(c => Math.abs(rgb[i + c] - right[i + c])));
    const grey = 225 + Math.trunc((right[i] + right[i + 1] + right[i + 2]) / 28);
    return most === 0 ? [grey, grey, grey]
        : [240 - Math.trunc(most / 3), most < 40 ? 170 - 4 * most : 10, 20];
}

function figureOf(scene, tier, rgb, right) {
    const pixels = scene.width * scene.height;
    let wrong = 0;
    for (let i = 0; i < 3 * pixels; i += 3)
        wrong += [0, 1, 2].some(c => rgb[i + c] !== right[i + c]);
    const note = rgb === right ? 'the right picture' : wrong === 0 ? 'every pixel as exact'
        : (100 * wrong / pixels).toFixed(wrong * 10 < pixels ? 1 : 0) + ' % of the pixels wrong';
    const made = element('figure', {}, element('figcaption', {}, bold(tier), ' ' + note),
        canvasOf(scene, tier + ', the picture', i => rgb.subarray(i, i + 3)));
    if (rgb !== right)
        made.append(canvasOf(scene, tier + ', where it differs from exact',
            i => difference(rgb, right, i)));
    return made;
}

function album() {
    const here = section('pictures', 'The same scene, by each tier', 'pictures');
    for (const scene of report.pictures) {
        const [title, text] = pictures[scene.name] || [scene.name, ''];
        const drawn = Object.entries(scene.tiers).map(([tier, text]) => [tier, bytesOf(text)]);
        const right = drawn.find(([tier]) => tier === 'exact')[1];
        here.append(element('section', {}, h3(title), element('p', {}, text),
            element('div', {class: 'pictures'},
                ...drawn.map(([tier, rgb]) => figureOf(scene, tier, rgb, right))),
            element('details', {}, element('summary', {}, 'This scene as a file'),
                element('pre', {}, scene.file))));
    }
}
