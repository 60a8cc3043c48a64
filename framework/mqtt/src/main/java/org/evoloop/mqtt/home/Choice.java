package org.evoloop.mqtt.home;

import static java.util.Objects.requireNonNull;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.evoloop.console.OfferedModels;
import org.evoloop.converter.SystemEventConverter;

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

    /** The new model, called as its machine, or with its file if two are called so. */
    static Choice among(OfferedModels offered, SystemEventConverter converter) {
        Map<String, String> references = named(offered);
        return new Choice(
                "Model",
                List.copyOf(references.keySet()),
                () -> references.entrySet().stream()
                        .filter(each -> offered.running().equals(Optional.of(each.getValue())))
                        .map(Map.Entry::getKey)
                        .findFirst()
                        .orElseGet(
                                () -> converter.knowledge().models().evolved().name()),
                name -> offered.choose(requireNonNull(references.get(name))));
    }

    /** What is offered: each model's reference by its name here. */
    static Map<String, String> named(OfferedModels offered) {
        Map<String, String> references = new LinkedHashMap<>();
        for (String reference : offered.references()) {
            String machine = reference.substring(reference.lastIndexOf('#') + 1);
            references.put(references.containsKey(machine) ? reference : machine, reference);
        }
        return references;
    }

    /** Its name in topics and JSON. */
    String key() {
        return HomeDiscovery.key(name);
    }
}
