package org.evoloop.engine;

import java.util.ArrayList;
import java.util.List;

/** How a core receives an input: as it is, or with one of its mechanisms removed. */
@FunctionalInterface
interface Wiring {
    /** The core's outputs, and its snapshot afterwards. */
    record Result(List<Output> said, Snapshot after) {}

    /** The core as it is. */
    Wiring REAL = (rules, before, input) -> {
        List<Output> said = new ArrayList<>();
        Core core = new Core(rules, before, said::add);
        core.apply(input);
        return new Result(said, core.snapshot());
    };

    Result apply(Rules rules, Snapshot before, Input input);
}
