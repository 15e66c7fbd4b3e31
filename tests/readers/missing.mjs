/** A program that is not on this machine, with the reason. */
export class Missing extends Error {}
