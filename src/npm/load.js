// SPDX-License-Identifier: MIT
/* A module of the package, from the file beside this one: in Node from disk, else by fetch. */
export async function load(name) {
    const url = new URL(name, import.meta.url);
    if (url.protocol !== 'file:')
        return WebAssembly.compileStreaming(fetch(url));
    const { readFile } = await import('node:fs/promises');
    return WebAssembly.compile(await readFile(url));
}
