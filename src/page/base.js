// SPDX-License-Identifier: MIT
/* What the three parts of the page share. */

export const $ = id => document.getElementById(id);

/* An element with attributes and children; text is text. */
export function element(name, attributes = {}, ...children) {
    const made = document.createElement(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (key.startsWith('on'))
            made.addEventListener(key.slice(2), value);
        else if (value === true || typeof value === 'string' || typeof value === 'number')
            made.setAttribute(key, value === true ? '' : value);
    }
    made.append(...children);
    return made;
}

/* To draw there, and to read what was drawn. */
export const contextOf = canvas => canvas.getContext('2d', { willReadFrequently: true });

/* A key that is the browser's, such as Alt with an arrow. */
export const isCommand = event => event.altKey || event.ctrlKey || event.metaKey;

export const grouped = number => number.toLocaleString('en');

/* In few digits, as people read them. */
export function short(number) {
    if (number === undefined || Number.isNaN(number))
        return '';
    const small = number !== 0 && (Math.abs(number) < 1e-3 || Math.abs(number) >= 1e5);
    return small ? number.toExponential(1) : String(Number(number.toPrecision(3)));
}

/* A module from the page itself: gzip in base64. */
export async function moduleOf(id) {
    const text = $(id).textContent.trim();
    const bytes = Uint8Array.from(atob(text), letter => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

/* Where a worker of the page begins. It is told the modules that it needs. */
export function startWorker(told, heard) {
    const source = new Blob([$('worker-source').textContent], { type: 'text/javascript' });
    const url = URL.createObjectURL(source), worker = new Worker(url);
    worker.onmessage = ({ data }) => heard(data);
    worker.onerror = event => heard({ kind: 'error', message: event.message });
    told.forEach(message => worker.postMessage(message));
    worker.addEventListener('message', () => URL.revokeObjectURL(url), { once: true });
    return worker;
}

/* The part that the address names, and what it says of it: #see&shape=cone&... */
export function readHash() {
    const [part, ...rest] = location.hash.slice(1).split('&');
    return { part, said: Object.fromEntries(new URLSearchParams(rest.join('&'))) };
}

export function hashOf(part, said) {
    return `#${part}&${new URLSearchParams(said)}`;
}

/* Text in an address: deflated, base64 as addresses have it. */
export async function packed(text) {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('deflate-raw'));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    const letters = Array.from(bytes, byte => String.fromCharCode(byte)).join('');
    return btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

export async function unpacked(text) {
    const letters = atob(text.replace(/-/g, '+').replace(/_/g, '/'));
    const bytes = Uint8Array.from(letters, letter => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
    return new Response(stream).text().catch(() => { /* browsers say that nothing was fetched */
        throw new TypeError('it is cut off, or spoiled');
    });
}
