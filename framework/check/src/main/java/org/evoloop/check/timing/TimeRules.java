package org.evoloop.check.timing;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * All lines about time in the property file of an evolution.
 *
 * <p>Threading: immutable.
 *
 * @param properties the properties, in the file's order
 * @since 0.1
 */
public record TimeRules(List<TimeProperty> properties, List<Assumption> assumptions, List<Reaction> reactions) {
    /** No lines about time. */
    public static final TimeRules NONE = new TimeRules(List.of(), List.of(), List.of());

    public TimeRules {
        properties = List.copyOf(properties);
        assumptions = List.copyOf(assumptions);
        reactions = List.copyOf(reactions);
    }

    /** The assumptions of one kind. */
    public <A extends Assumption> List<A> assumptions(Class<A> kind) {
        return assumptions.stream().filter(kind::isInstance).map(kind::cast).toList();
    }

    /** The assumption of one kind that matches {@code wanted}. */
    <A extends Assumption> Optional<A> find(Class<A> kind, Predicate<A> wanted) {
        return assumptions(kind).stream().filter(wanted).findFirst();
    }
}
