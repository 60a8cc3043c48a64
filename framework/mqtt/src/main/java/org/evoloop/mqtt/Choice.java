package org.evoloop.mqtt;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * A choice that can be made while a converter runs, such as its new model.
 *
 * <p>Threading: its functions are called on a thread of {@link HomeAssistant}.
 *
 * @param name its name for people, such as {@code Model}
 * @param options the options
 * @param current supplies the present option
 * @param choose chooses one of the options; an exception's message is shown as the reason why that was refused
 * @since 0.1
 */
public record Choice(String name, List<String> options, Supplier<String> current, Consumer<String> choose) {

    /** @throws IllegalArgumentException if there are no options */
    public Choice {
        options = List.copyOf(options);
        if (options.isEmpty()) {
            throw new IllegalArgumentException("there is no " + name + " to choose");
        }
    }

    /** Its name in topics and JSON. */
    String key() {
        return HomeDiscovery.key(name);
    }
}
