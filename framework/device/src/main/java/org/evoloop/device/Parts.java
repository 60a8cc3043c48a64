package org.evoloop.device;

import java.io.IOException;
import java.util.List;
import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.DeviceLink;
import org.evoloop.converter.EventExecute;
import org.evoloop.converter.EventMonitor;
import org.jspecify.annotations.Nullable;

/**
 * What a connection consists of.
 *
 * <p>Threading: as its components.
 *
 * @param link for the status; null if there is nothing to show
 * @param open opens it, without waiting for the other end
 * @param close ends it; idempotent
 * @param commands further ones of the console
 * @since 0.1
 */
public record Parts(
        List<? extends EventMonitor> monitors,
        List<? extends EventExecute> executes,
        @Nullable DeviceLink link,
        Opening open,
        Runnable close,
        List<ConsoleCommand> commands) {

    /** Opens a connection. */
    @FunctionalInterface
    public interface Opening {
        /**
         * Opens it.
         *
         * @throws IOException if this computer lacks what it takes; the message says what to do
         */
        void open() throws IOException;
    }

    public Parts {
        monitors = List.copyOf(monitors);
        executes = List.copyOf(executes);
        commands = List.copyOf(commands);
    }

    /** A copy whose link is not shown, and which nobody waits for. */
    Parts withoutLink() {
        return new Parts(monitors, executes, null, open, close, commands);
    }

    /** Without commands. */
    public Parts(
            List<? extends EventMonitor> monitors,
            List<? extends EventExecute> executes,
            @Nullable DeviceLink link,
            Opening open,
            Runnable close) {
        this(monitors, executes, link, open, close, List.of());
    }
}
