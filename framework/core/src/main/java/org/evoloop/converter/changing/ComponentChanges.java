package org.evoloop.converter.changing;

import org.evoloop.converter.running.Assembly;
import org.evoloop.converter.running.ConverterShell;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.loop.Component;
import org.jspecify.annotations.Nullable;

/**
 * The components of a converter, and how they change, also while it runs.
 *
 * <p>Threading: guarded by its converter.
 */
final class ComponentChanges {
    private final Ownership ownership;
    private Assembly present = new Assembly();

    ComponentChanges(Ownership ownership) {
        this.ownership = ownership;
    }

    Assembly present() {
        return present;
    }

    /** @param built null before the converter is built */
    void add(@Nullable ConverterShell built, Component component) {
        Assembly changed = present.with(component);
        if (built != null) {
            DecisionTable table = changed.decisions(built.knowledge());
            taking(component, () -> built.join(component));
            built.use(table, changed);
        }
        present = changed;
    }

    void remove(ConverterShell built, String name) {
        Assembly changed = present.without(name);
        DecisionTable table = changed.has(Component.Role.EXECUTE)
                ? changed.decisions(built.knowledge())
                : built.driver().rules().table();
        built.loop().remove(name, () -> built.use(table, changed));
        ownership.giveBack(present.require(name));
        present = changed;
    }

    void exchange(ConverterShell built, String name, Component next) {
        built.loop().requireExchangeable(name, next);
        Assembly changed = present.with(name, next);
        DecisionTable table = changed.decisions(built.knowledge());
        taking(next, () -> {
            built.attach(next);
            built.loop().exchange(name, next, () -> built.use(table, changed));
        });
        ownership.giveBack(present.require(name));
        present = changed;
    }

    /** Takes ownership of {@code component} for {@code change}; gives it back if that is refused. */
    private void taking(Component component, Runnable change) {
        ownership.take(component, component.name());
        try {
            change.run();
        } catch (RuntimeException refused) {
            ownership.giveBack(component);
            throw refused;
        }
    }
}
