package org.evoloop.core;

import java.util.ArrayList;
import java.util.List;

/** How a core is told something: itself, or with one of its mechanisms taken out. */
@FunctionalInterface
interface Wiring {
    /** What the core said, and what it knew then. */
    record Result(List<Output> said, Snapshot after) {}

    /** The core as it is. */
    Wiring REAL = (rules, before, input) -> {
        List<Output> said = new ArrayList<>();
        Core core = new Core(rules, before, said::add);
        core.apply(input);
        return new Result(said, core.snapshot());
    };

    Result tell(Rules rules, Snapshot before, Input input);
}
