// SPDX-License-Identifier: MIT
/* Writes tables.mts: the words of the types are those that the library has. */
import { writeFileSync } from 'node:fs';
import { parts, shapes, statuses, tiers } from 'surehit';
import { margins } from 'surehit/judge';

const tables = { Shape: shapes, Tier: tiers, Status: statuses, Part: parts, MarginUnit: margins };
const lines = [
    "import type { Shape, Tier, Status, Part } from 'surehit';",
    "import type { MarginUnit } from 'surehit/judge';",
    'type Same<A, B> = [A] extends [B] ? [B] extends [A] ? true : never : never;',
];
for (const [type, words] of Object.entries(tables))
    lines.push(`const of${type} = ${JSON.stringify(words)} as const;`,
               `export const same${type}: Same<${type}, typeof of${type}[number]> = true;`);
writeFileSync('tables.mts', lines.join('\n'));
