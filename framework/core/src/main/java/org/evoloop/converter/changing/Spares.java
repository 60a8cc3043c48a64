package org.evoloop.converter.changing;

import static java.util.Objects.requireNonNull;

import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.evoloop.loop.Component;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Spare components, ready to replace others.
 *
 * <p>Threading: thread-safe; listing them does not wait for a change of the converter.
 */
final class Spares {
    private static final Logger LOG = LoggerFactory.getLogger(Spares.class);

    private final Map<String, Supplier<? extends Component>> byName = new LinkedHashMap<>();

    /** Those that were made to learn their role and wait for their use. */
    private final Map<String, Component> made = new HashMap<>();

    /** @throws IllegalStateException if the name is taken */
    void add(String name, Supplier<? extends Component> spare) {
        requireNonNull(name, "the name of a spare is null");
        requireNonNull(spare, "the spare " + name + " is null");
        synchronized (byName) {
            if (byName.putIfAbsent(name, spare) != null) {
                throw new IllegalStateException("there is a spare named " + name + " already");
            }
        }
    }

    /**
     * Makes the component of this name.
     *
     * @throws IllegalArgumentException if there is none; the message lists the names
     */
    Component make(String name) {
        Supplier<? extends Component> supplier;
        synchronized (byName) {
            Component ready = made.remove(name);
            if (ready != null) {
                return ready;
            }
            supplier = byName.get(name);
        }
        if (supplier == null) {
            Set<String> names = names();
            throw new IllegalArgumentException("no spare is named " + name + "; there are "
                    + (names.isEmpty() ? "none" : String.join(", ", names)));
        }
        return requireNonNull(supplier.get(), "the spare " + name + " is null");
    }

    /** The names of those with {@code role}, in order. */
    Set<String> of(Component.Role role) {
        Set<String> fitting = new LinkedHashSet<>();
        synchronized (byName) {
            byName.forEach((name, supplier) -> {
                try {
                    if (made.computeIfAbsent(name, asked -> supplier.get()).role() == role) {
                        fitting.add(name);
                    }
                } catch (RuntimeException failure) {
                    LOG.debug("the spare {} cannot be made", name, failure);
                }
            });
        }
        return fitting;
    }

    /** In the order in which they were added. */
    Set<String> names() {
        synchronized (byName) {
            return Collections.unmodifiableSet(new LinkedHashSet<>(byName.keySet()));
        }
    }
}
