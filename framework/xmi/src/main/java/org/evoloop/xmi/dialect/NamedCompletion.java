package org.evoloop.xmi.dialect;

import java.util.List;
import java.util.regex.Pattern;

/**
 * Finds transitions whose authors probably wrote the event where the name belongs. Without a trigger, a transition is
 * taken as soon as its state is done.
 */
public final class NamedCompletion {
    /** What tools write by themselves. */
    private static final Pattern DEFAULT_NAME = Pattern.compile("(?i)transition[ _-]?[0-9]*");

    private NamedCompletion() {}

    /**
     * Reports a transition that has a name and no trigger.
     *
     * @param source the vertex that it leaves
     * @param events its triggers
     */
    public static void check(UmlElement transition, UmlElement source, List<String> events, Problems problems) {
        String name = transition.name();
        if (events.isEmpty() && !name.isEmpty() && !DEFAULT_NAME.matcher(name).matches()) {
            problems.add(
                    transition.place(),
                    "transition " + transition.label() + " has no trigger, so that it is taken as soon as state "
                            + source.label()
                            + " is done, and its name is not an event; give it a trigger with the event "
                            + Problems.quote(name) + ", or remove the name");
        }
    }
}
