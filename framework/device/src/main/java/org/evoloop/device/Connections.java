package org.evoloop.device;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import org.evoloop.device.file.Node;
import org.evoloop.device.file.Section;
import org.evoloop.statemachine.Names;
import org.jspecify.annotations.Nullable;

/** The connections of a device file, by name. */
final class Connections {
    private final Map<String, Connection> byName = new LinkedHashMap<>();
    private final Computer computer = new Computer();
    /** Those that were refused: a rule that names one is no second mistake. */
    private final List<String> refused = new ArrayList<>();

    private boolean allFound = true;

    /** Reads the section {@code connections} of {@code file}. */
    static Connections read(Section file, FileModels models) {
        Map<String, ConnectionKind> kinds = kinds();
        Connections connections = new Connections();
        file.named("connections").forEach((name, section) -> {
            ConnectionKind kind = section.oneOf(kinds.keySet(), meant(section, kinds.keySet()))
                    .map(kinds::get)
                    .orElse(null);
            if (kind == null) {
                connections.refused.add(name.value());
            } else {
                connections.byName.put(name.value(), kind.read(name.value(), section, models));
                section.done();
            }
        });
        return connections;
    }

    private static String meant(Section section, Collection<String> kinds) {
        return section.keys().stream()
                .map(key -> Names.meant(key.value(), kinds))
                .filter(hint -> !hint.isEmpty())
                .findFirst()
                .orElse("");
    }

    private static Map<String, ConnectionKind> kinds() {
        Map<String, ConnectionKind> kinds = new TreeMap<>();
        ServiceLoader.load(ConnectionKind.class).forEach(kind -> kinds.put(kind.key(), kind));
        return kinds;
    }

    /**
     * The connection that {@code section} names with {@code key}, or the only one if it names none, or this computer if it
     * says {@code run}; null if there is none, which is noted.
     */
    @Nullable
    Connection named(Section section, String key) {
        if (section.has("run") && !section.has(key)) {
            return computer;
        }
        Node.Text name = section.text(key).orElse(null);
        if (name == null) {
            if (byName.size() == 1 && refused.isEmpty()) {
                return byName.values().iterator().next();
            }
            allFound = false;
            if (!section.has(key) && refused.isEmpty()) {
                section.problem(section.name() + " needs " + key + ", the name of a connection"
                        + Names.hint("", byName.keySet()));
            }
            return null;
        }
        Connection found = byName.get(name.value());
        allFound &= found != null;
        if (found == null && !refused.contains(name.value())) {
            section.problems()
                    .at(name, "there is no connection '" + name + "'" + Names.hint(name.value(), byName.keySet()));
        }
        return found;
    }

    /** Whether none was refused or not found, so that all keys that they ask for are known. */
    boolean areKnown() {
        return refused.isEmpty() && allFound;
    }

    /** All of them, in the order of the file, and this computer. */
    Collection<Connection> all() {
        List<Connection> all = new ArrayList<>(byName.values());
        all.add(computer);
        return all;
    }
}
