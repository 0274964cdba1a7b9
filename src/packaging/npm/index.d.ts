// SPDX-License-Identifier: GPL-3.0-or-later

export interface RenderOptions {
    /** Pixels; 160 by 120 if neither the options nor the scene say anything else. */
    width?: number;
    height?: number;
    /** Further options of the command line, such as "--samples", "16"; see `candelabra --help`. */
    options?: string[];
    /** Files that the scene reads, by their names relative to it. */
    files?: Record<string, string | Uint8Array>;
    /** Ends the rendering; the promise is then rejected with the signal's reason. */
    signal?: AbortSignal;
}

export interface Rendered {
    /** The bytes of a PNG file. The same scene and options give the same bytes on every machine. */
    picture: Uint8Array;
    /** Warnings and what the scene has printed. */
    messages: string;
}

/** A scene that cannot be rendered; the message has all errors with their places. */
export class SceneError extends Error {
    /** The exit status that the command line would have: 1 the scene, 2 an option, 3 a file or memory. */
    status: number;
}

/**
 * Renders the text of a scene in a thread of its own. The scene reads the library and the given files, and nothing of the
 * disk. Rejects with a SceneError if there is no picture.
 */
export function render(scene: string, options?: RenderOptions): Promise<Rendered>;
