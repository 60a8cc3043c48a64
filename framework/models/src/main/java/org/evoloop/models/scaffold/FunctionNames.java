package org.evoloop.models.scaffold;

import java.util.LinkedHashMap;
import java.util.Map;
import org.evoloop.statemachine.State;

/** The class names for new states. A state keeps its class name when other states are added or removed. */
final class FunctionNames {
    private static final String PACKAGE = "package ";

    private final JavaNames names = new JavaNames().reserve("NewFunction");
    private final Map<String, String> byState = new LinkedHashMap<>();
    private final Map<String, String> used = new LinkedHashMap<>();
    private String javaPackage = "";

    private FunctionNames() {}

    /** @param text as written by {@link #text}; empty for a new project */
    static FunctionNames parse(String text) {
        FunctionNames parsed = new FunctionNames();
        for (String line : text.lines().toList()) {
            int blank = line.indexOf(' ');
            if (line.startsWith(PACKAGE)) {
                parsed.javaPackage = line.substring(PACKAGE.length());
            } else if (blank > 0) {
                parsed.byState.put(line.substring(blank + 1), line.substring(0, blank));
                parsed.names.reserve(line.substring(0, blank));
            }
        }
        return parsed;
    }

    /** @throws IllegalArgumentException if the project has another package */
    void requirePackage(String wanted) {
        if (!javaPackage.isEmpty() && !javaPackage.equals(wanted)) {
            throw new IllegalArgumentException(
                    "--package: the project was begun as " + javaPackage + "; name that, or another directory");
        }
    }

    String of(State state) {
        String key = key(state);
        String name =
                byState.computeIfAbsent(key, fresh -> names.free(JavaNames.camel(state.name(), "State") + "Function"));
        used.put(key, name);
        return name;
    }

    /** A key on one line, whatever the name contains. */
    private static String key(State state) {
        return JavaText.literal(state.name());
    }

    /** The text that {@link #parse} reads. */
    String text(String wanted) {
        StringBuilder text = new StringBuilder(PACKAGE).append(wanted).append('\n');
        used.forEach(
                (state, name) -> text.append(name).append(' ').append(state).append('\n'));
        return text.toString();
    }
}
