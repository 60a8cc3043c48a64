package org.evoloop.roomba;

import org.evoloop.service.ServiceOptions;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options of a program that runs by itself. */
final class Unattended {
    @Option(names = "--start", description = "Converts events at once, and goes on when the standard input ends.")
    private boolean start;

    @Option(
            names = "--name",
            paramLabel = "NAME",
            description = "Takes commands for NAME: ctl NAME status (default: nothing listens).")
    private @Nullable String name;

    /** @throws IllegalArgumentException if the name is not one */
    ServiceOptions options() {
        ServiceOptions named =
                name == null ? ServiceOptions.none() : ServiceOptions.none().withName(name);
        return start ? named.withStart() : named;
    }
}
