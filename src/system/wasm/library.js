// SPDX-License-Identifier: GPL-3.0-or-later
// What the program asks of the page or of node that runs it. They give it as members of the Module;
// without them there is a usual answer.
addToLibrary({
    $candelabraState: {memoryLimit: 2 ** 53},

    // 0: nothing, 1: save, 2: stop.
    candelabra_interrupt: () => Module['interrupt'] ? Module['interrupt']() : 0,
    candelabra_listens: on => Module['listens']?.(on !== 0),

    candelabra_allow__deps: ['$UTF8ToString'],
    candelabra_allow: (path, rights) => Module['allow']?.(UTF8ToString(path), rights),

    // The engine's stack in bytes. Workers of browsers have a little less than 1 MB.
    candelabra_stack_bytes: () => Module['stackBytes'] ?? 900000,

    candelabra_free_memory: () => Module['freeMemory'] ?? 0,
    candelabra_limit_memory__deps: ['$candelabraState'],
    candelabra_limit_memory: bytes => {
        candelabraState.memoryLimit = Math.min(bytes, candelabraState.memoryLimit);
    },
    candelabra_memory_limit__deps: ['$candelabraState'],
    candelabra_memory_limit: () => candelabraState.memoryLimit,
});
