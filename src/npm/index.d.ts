// SPDX-License-Identifier: MIT
/** Ray-surface intersections whose answers can be trusted. */

export type Shape = 'plane' | 'disc' | 'sphere' | 'cylinder' | 'cone' | 'box';
/** How much an answer promises; `certain` decides right, `exact` also rounds right. */
export type Tier = 'float32' | 'textbook' | 'stable' | 'certain' | 'exact';
export type Status = 'miss' | 'hit' | 'invalid';
/** The piece of a shape's boundary that is hit. */
export type Part = 'surface' | 'base' | 'top' | 'wall' |
    'x_min' | 'x_max' | 'y_min' | 'y_max' | 'z_min' | 'z_max';
/** What is invalid. */
export type Field = 'o' | 'd' | 't_min' | 't_max' | 'point' | 'centre' | 'base' | 'normal' |
    'top' | 'apex' | 'radius' | 'low' | 'high';
/** What decided. */
export type Stage = 'double' | 'double-double' | 'mod128' | 'exact';

/** Three numbers. */
export type Vector = readonly [number, number, number] | ArrayLike<number>;

/** All t with tMin <= t <= tMax count; they are 0 and Infinity unless told. */
export interface Ray {
    origin: Vector;
    direction: Vector;
    tMin?: number;
    tMax?: number;
}

/** Each shape's numbers by name. */
export interface Objects {
    plane: { point: Vector; normal: Vector };
    disc: { centre: Vector; normal: Vector; radius: number };
    sphere: { centre: Vector; radius: number };
    cylinder: { base: Vector; top: Vector; radius: number };
    cone: { base: Vector; apex: Vector; radius: number };
    box: { low: Vector; high: Vector };
}

/** A ray as 8 numbers: origin, direction, tMin, tMax. */
export type RayNumbers = readonly number[] | Float64Array;
/** An object as its numbers in the order of its fields. */
export type ObjectNumbers = readonly number[] | Float64Array;

export interface Hit {
    status: 'hit';
    t: number;
    /** The true t is no farther away; Infinity where the tier promises nothing. */
    tError: number;
    part: Part;
    /** The ray comes from a solid's inside and leaves it here. */
    leaves: boolean;
    /** Outward, of length 1. */
    normal: [number, number, number];
}
export interface Miss { status: 'miss' }
export interface Invalid { status: 'invalid'; field: Field }

export interface Interval {
    status: 'hit';
    tEnter: number;
    tLeave: number;
    enterPart: Part;
    leavePart: Part;
}

/** One entry a ray. Of what is no hit t, tError and normal are NaN, part and leaves 0. */
export interface Hits {
    /** Indices of `statuses`. */
    status: Uint8Array;
    /** Indices of `parts`. */
    part: Uint8Array;
    leaves: Uint8Array;
    t: Float64Array;
    tError: Float64Array;
    /** Three a ray; not there where none were wanted. */
    normal?: Float64Array;
}

export const shapes: readonly Shape[];
export const tiers: readonly Tier[];
export const statuses: readonly Status[];
export const parts: readonly Part[];

/** The first boundary point of the object on the ray. */
export function hit<S extends Shape>(shape: S, tier: Tier, ray: Ray | RayNumbers,
                                     object: Objects[S] | ObjectNumbers): Hit | Miss | Invalid;

/**
 * Many rays, 8 numbers each, that ask one object, or each its own: as many times the object's
 * numbers. The answers are those of `hit`, bit for bit.
 */
export function hits(shape: Shape, tier: Tier, rays: Float64Array, objects: Float64Array,
                     options?: { normals?: boolean }): Hits;

/** Is there a hit at all? */
export function occluded<S extends Shape>(shape: S, tier: Tier, ray: Ray | RayNumbers,
                                          object: Objects[S] | ObjectNumbers): Status;

/** Both ends of the chord that the ray's whole line cuts from the closed object. */
export function interval<S extends Shape>(shape: S, tier: Tier, ray: Ray | RayNumbers,
                                          object: Objects[S] | ObjectNumbers):
    Interval | Miss | Invalid;

/** The first invalid field, or 'none'. */
export function check<S extends Shape>(shape: S, ray: Ray | RayNumbers,
                                       object: Objects[S] | ObjectNumbers): Field | 'none';

/** Which stage answers `hit`. */
export function stage<S extends Shape>(shape: S, tier: Tier, ray: Ray | RayNumbers,
                                       object: Objects[S] | ObjectNumbers): Stage;
