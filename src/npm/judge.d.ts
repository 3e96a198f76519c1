// SPDX-License-Identifier: MIT
/** Hard cases, and a routine of one's own held against the exact answers to them. */

import type {
    Hit, ObjectNumbers, Objects, Part, Ray, RayNumbers, Shape, Tier,
} from './index.js';

/** A named generator of cases. */
export type Regime = string;
export type MarginUnit = 'none' | 'size' | 'distance' | 'length' | 'ulps' | 'growth';

/** A miss, a hit by its t alone or with what else is known, or the word for invalid input. */
export type Answer = null | undefined | false | 'miss' | 'invalid' | true | number |
    { t: number; part?: Part | null; normal?: ArrayLike<number> | null };

/** Asked with each number as it is: arrays of three, tMin and tMax told. */
export type Routine = (ray: {
    origin: [number, number, number]; direction: [number, number, number];
    tMin: number; tMax: number;
}, object: any, shape: Shape) => Answer;

export interface Errors {
    hits: number; correctly_rounded: number;
    median: number; 99: number; '99.99': number; most: number;
}

/** A row of `surehit judge --json`, but for times. */
export interface Row {
    shape: Shape; query: 'hit'; regime: Regime;
    cases: number; valid: number; hits: number; skipped: number; unasked: number;
    /** Of the valid: decisions that are wrong, or none; their share, with 95 % confidence. */
    wrong: number; wrong_from: number; wrong_to: number;
    faults: Record<string, number>;
    t_ulps: Errors; t_relative: Errors; t_extents: Errors; t_pixels: Errors;
    normal_ulps: Errors; normal: Errors;
    /** Wrong decisions that stay wrong wherever the faces go by so much. */
    margins?: { unit: MarginUnit; wrong: { beyond: number; wrong: number }[]; most: number };
    decisions: { wrong: Record<string, number>; allowed: Record<string, number> };
}

/** A case made simple, as lines. */
export interface Worst {
    kind: string; shape: Shape; query: 'hit'; regime: Regime;
    case: string; answer: string; right: string;
    ulps?: number; margin?: number; event?: string;
}

export interface Verdict {
    rows: Row[];
    conventions: Partial<Record<Shape, Record<string, { says: string; contract: string }>>>;
    worst: Worst[];
    /** What the routine threw, the first few. */
    thrown: unknown[];
}

export interface JudgeOptions {
    /** All unless told. */
    shapes?: Shape[];
    regimes?: Regime[];
    /** Cases of each shape and regime: 2000 unless told. */
    count?: number;
    seed?: number;
    /** What margins are told in: 'size' unless told. */
    margin?: MarginUnit;
    /** Entry conditions in the judge's words: 'unit outside touch=miss'. */
    entry?: string;
    /** The routine computes in single precision: cases are floats, and so is the truth. */
    float?: boolean;
    /** Each row as it is done, and how many there are to be. */
    onRow?: (row: Row, rows: number) => void;
}

export const regimes: readonly Regime[];
export const margins: readonly MarginUnit[];

/** Has the shape such cases? */
export function applies(shape: Shape, regime: Regime): boolean;

/** Cases `first` and on of a regime, for `hits`: whole numbers from 0 to 2 ** 53 - 1. */
export function cases(shape: Shape, regime: Regime,
                      options?: { count?: number; seed?: number; first?: number }):
    { rays: Float64Array; objects: Float64Array };

/**
 * Holds a routine against `exact`. One at a time: neither the routine nor `onRow` may call it, which
 * throws an Error.
 */
export function judge(routine: Routine, options?: JudgeOptions): Verdict;

/** A case as a line of `surehit cases`; a tier's answer as one of `surehit answer`. */
export function caseLine<S extends Shape>(shape: S, ray: Ray | RayNumbers,
                                          object: Objects[S] | ObjectNumbers): string;
export function answerLine<S extends Shape>(shape: S, tier: Tier, ray: Ray | RayNumbers,
                                            object: Objects[S] | ObjectNumbers): string;
export function readCase(line: string): { shape: Shape; ray: Ray; object: any };
