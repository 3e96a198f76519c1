// SPDX-License-Identifier: MIT
/* Functions that somebody wrote, by the shape that they meet. */

/* {sphere: function, ...} of the shapes that the code defines; throws what it throws. */
export function routinesOf(code, shapes) {
    const ends = shapes.map(shape => `${shape}: typeof ${shape} === 'function' ? ${shape} : null`);
    const all = new Function(`"use strict";\n${code}\n;return {${ends.join(', ')}};`)();
    return Object.fromEntries(Object.entries(all).filter(([, routine]) => routine));
}

/* What somebody threw, which may be anything. */
export function wordsOf(thrown) {
    try {
        return String(thrown);
    } catch {
        return 'what has no words';
    }
}
