package org.evoloop.device;

import org.evoloop.console.ConsoleCommand;
import org.evoloop.converter.PushMonitor;
import org.evoloop.converter.SystemEventConverter;

/**
 * A person who says where a device is that cannot be asked.
 *
 * <p>Threading: as {@link PushMonitor}.
 */
final class FoundMonitor extends PushMonitor {
    private FoundMonitor() {
        super("Person");
    }

    /** The command by which a person says that, of a converter that hears of it. */
    static ConsoleCommand command(SystemEventConverter converter) {
        FoundMonitor person = new FoundMonitor();
        converter.addMonitor(person);
        return ConsoleCommand.naming(
                        "found STATE",
                        "tells the converter in which state the device is, which cannot be asked for it",
                        () -> converter.knowledge().models().original().states(),
                        (state, more) -> person.push(person.foundIn(state)))
                .notOffered();
    }
}
