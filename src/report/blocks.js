// SPDX-License-Identifier: MIT
/* Many rays in one call: time a ray against the rays of a call. */

const CALLS = {width: 360, height: 236, left: 38, right: 296, top: 10, bottom: 196};

/* Both axes by powers of two. */
function callsPlane(all) {
    const {width, height, left, right, top, bottom} = CALLS;
    const rays = all[0].calls.map(call => call.rays), most = Math.log2(rays[rays.length - 1]);
    const times = all.flatMap(one => one.calls.map(call => call.certain)).filter(ns => ns);
    const low = Math.floor(Math.log2(Math.min(...times)));
    const high = Math.ceil(Math.log2(Math.max(...times)));
    const x = count => left + (right - left) * Math.log2(count) / most;
    const y = ns => bottom - (bottom - top) * (Math.log2(ns) - low) / (high - low);
    const svg = drawing('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img',
        'aria-label': 'Nanoseconds a ray against the rays of a call; the table has the same figures'});
    const text = (at, height, anchor, words, kind = '') => svg.append(drawing('text',
        {x: at, y: height, 'text-anchor': anchor, class: kind}, words));
    for (let power = low; power <= high; power++) {
        svg.append(drawing('path', {class: 'grid', d: `M${left} ${y(2 ** power)}H${right}`}));
        text(left - 4, y(2 ** power) + 3.5, 'end', String(2 ** power));
    }
    for (const number of rays.filter(number => Math.log2(number) % 2 === 0))
        text(x(number), bottom + 14, 'middle', String(number));
    text((left + right) / 2, bottom + 32, 'middle', 'rays a call');
    svg.append(drawing('text', {'text-anchor': 'middle',
        transform: `translate(12 ${(top + bottom) / 2}) rotate(-90)`}, 'ns a ray'));
    const ends = all.map(one => ({one, y: y(one.calls[one.calls.length - 1].certain || 1)}))
        .sort((a, b) => b.y - a.y);
    let free = bottom + 12;
    for (const end of ends) { // no name covers another one
        const points = end.one.calls.filter(call => call.certain);
        svg.append(drawing('path', {class: 'calls', d: points.map((call, i) =>
            `${i ? 'L' : 'M'}${x(call.rays).toFixed(1)} ${y(call.certain).toFixed(1)}`).join('')}));
        free = Math.min(free - 12, end.y + 3.5);
        text(right + 5, free, 'start', end.one.shape, 'name');
    }
    return svg;
}

function blocks() {
    const all = report.blocks.filter(one => one.calls.some(call => call.certain));
    if (!all.length)
        return;
    const here = section('blocks', 'Many rays in one call', 'blocks');
    const ns = number => cell(number ? number.toFixed(1) : '–');
    const last = one => one.calls[one.calls.length - 1];
    here.append(element('p', {}, 'Tier certain, mixed rays of the regime typical before one object, ' +
        'in nanoseconds a ray: naive code and certain one ray a call, certain with so many rays a ' +
        'call, and a naive loop that the compiler computes side by side.'),
    callsPlane(all), table('Nanoseconds a ray by the rays of a call', '', [
        [head(''), head('naive, one by one'), head('certain, one by one'),
            ...all[0].calls.map(call => head(count(call.rays))), head('naive block')]],
    all.map(one => named(one.shape, ns(one.naive), ns(one.certain),
        ...one.calls.map(call => ns(call.certain)), ns(last(one).naive_block)))),
    soft('surehit bench --block N --tier certain measures them more often; docs/your_renderer.md ' +
        'says how to call them.'));
}
