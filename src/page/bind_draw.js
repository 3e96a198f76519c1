// SPDX-License-Identifier: MIT
/* The tracer over an instance of its WebAssembly: src/wasm/draw.c. */
import { instance, textAt, words } from '../npm/bind.js';

const TILE = 32;

export function bindDraw(module) {
    const wasm = instance(module), encoder = new TextEncoder();

    /* The scene of a text in that size (0: its own); or what is wrong with it, and where. */
    function read(text, [width, height]) {
        const bytes = encoder.encode(text), at = wasm.text_room(bytes.length);
        new Uint8Array(wasm.memory.buffer, at, bytes.length).set(bytes);
        const done = wasm.read_scene(width, height) === 1, notes = textAt(wasm, wasm.messages());
        const list = notes.split('\n').filter(Boolean).map(line => {
            const [, row = 0, column = 0, kind = 'error', message] =
                /^(?:scene:(?:(\d+):(\d+):)? )?(?:(error|warning): )?(.*)$/.exec(line);
            return { line: Number(row), column: Number(column), kind, message };
        });
        return done ? { width: wasm.scene_width(), height: wasm.scene_height(), notes: list }
                    : { notes: list };
    }

    function* tiles({ width, height }) {
        for (let y = 0; y < height; y += TILE)
            for (let x = 0; x < width; x += TILE)
                yield { x, y, width: Math.min(TILE, width - x), height: Math.min(TILE, height - y) };
    }

    /* Its pixels as RGBA; `wrong`: how many pixels the certificate is wrong about, asked of exact. */
    function tile(tier, { x, y, width, height }, check) {
        const at = wasm.draw_tile(words(wasm, wasm.tier_name).indexOf(tier), x, y, width, height,
                                  check ? 1 : 0);
        if (at === 0)
            throw new Error('no memory for the picture');
        const pixels = new Uint8ClampedArray(wasm.memory.buffer.slice(at, at + 4 * width * height));
        return { pixels, wrong: check ? wasm.check_tile() : undefined };
    }

    return { read, tiles, tile };
}
