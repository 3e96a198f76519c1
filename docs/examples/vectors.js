// SPDX-License-Identifier: MIT
// As vectors.py: node vectors.js FILE
const { readFileSync } = require('fs')

function vectors(path) {
    const bytes = readFileSync(path), start = bytes.indexOf(10) + 1
    const head = JSON.parse(bytes.toString('latin1', 0, start))
    let digest = 0xcbf29ce484222325n
    for (const byte of bytes.subarray(start))
        digest = BigInt.asUintN(64, (digest ^ BigInt(byte)) * 0x100000001b3n)
    if (head.surehit_vectors !== 2 || BigInt('0x' + head.digest) !== digest)
        throw new Error(`${path}: another version, or spoiled`)
    return bytes.toString('latin1', start).trim().split('\n').map(line => JSON.parse(line))
}

const number = bits => Buffer.from(bits, 'hex').readDoubleBE()

for (const vector of vectors(process.argv[2])) {
    const { answer, event, margin = {} } = vector
    const other = answer === 'hit' ? 'miss' : 'hit'
    const t = answer === 'hit' ? [number(vector.t_bits)] : []
    const mayBe = margin[other] <= 1e-9 || event === 'touch'
    console.log(...vector.case_bits.map(number), ':', answer, ...t, mayBe ? 'or ' + other : '')
}
