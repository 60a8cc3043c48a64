package org.evoloop.mqtt;

import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * One of several things that can be chosen while a converter runs, such as its new model.
 *
 * <p>Threading: its functions are called on a thread of {@link HomeAssistant}.
 *
 * @param name for people, such as {@code Model}
 * @param options what there is to choose from
 * @param current what is chosen
 * @param choose chooses one of the options; an exception's message is shown as the reason why that was refused
 * @since 0.1
 */
public record Choice(String name, List<String> options, Supplier<String> current, Consumer<String> choose) {

    /** @throws IllegalArgumentException if there is nothing to choose */
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
