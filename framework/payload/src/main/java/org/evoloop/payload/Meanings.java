package org.evoloop.payload;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.evoloop.evolution.Values;
import org.evoloop.time.Clock;

/**
 * What messages mean: events of a controller or a device, or states of a device. The first rule that applies counts; a
 * message without one means nothing.
 *
 * <pre>{@code
 * Meanings.at("/mode", Map.of("off", "Off", "cool", "Cool"))
 * Meanings.of(Map.of("single", "power")).with(Match.matching(Pattern.compile("turn (?<degrees>[0-9]+)")), "turn")
 * }</pre>
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class Meanings {
    /** Nothing has a meaning yet; see {@link #with}. */
    public static final Meanings NONE = new Meanings(List.of(), Duration.ZERO);

    private final List<Rule> rules;
    private final Duration lasting;

    private record Rule(Match match, String name) {}

    /**
     * What one message means.
     *
     * @param name the event or the state
     * @param values of the event
     * @since 0.1
     */
    public record Meaning(String name, Values values) {}

    private Meanings(List<Rule> rules, Duration lasting) {
        this.rules = rules;
        this.lasting = lasting;
    }

    /**
     * Messages that mean something as a whole.
     *
     * @param exact the names, by message
     */
    public static Meanings of(Map<String, String> exact) {
        return in(Part.WHOLE, exact);
    }

    /**
     * Messages that mean something by their value at this JSON pointer; see {@link Part#at}.
     *
     * @param exact the names, by value
     */
    public static Meanings at(String pointer, Map<String, String> exact) {
        return in(Part.at(pointer), exact);
    }

    private static Meanings in(Part part, Map<String, String> exact) {
        return new Meanings(
                exact.entrySet().stream()
                        .map(each -> new Rule(Match.exactly(each.getKey()).in(part), each.getValue()))
                        .toList(),
                Duration.ZERO);
    }

    /** A copy with one more rule, after the others. */
    public Meanings with(Match match, String name) {
        List<Rule> more = new ArrayList<>(rules);
        more.add(new Rule(match, name));
        return new Meanings(List.copyOf(more), lasting);
    }

    /** A copy whose meanings count once they have held for a time, which a connection measures. */
    public Meanings lasting(Duration time) {
        return new Meanings(rules, Clock.requireDelay(time));
    }

    /** How long a meaning must hold to count; zero if it counts at once. */
    public Duration lasting() {
        return lasting;
    }

    /** The meaning of a message; empty if it has none. */
    public Optional<Meaning> of(String message) {
        Part looked = Part.WHOLE;
        Optional<String> text = Optional.of(message);
        for (Rule rule : rules) {
            // Rules usually look at the same part, which is read once.
            if (looked != rule.match().part()) {
                looked = rule.match().part();
                text = looked.in(message);
            }
            Optional<Values> values = text.flatMap(found -> rule.match().of(message, found));
            if (values.isPresent()) {
                return Optional.of(new Meaning(rule.name(), values.get()));
            }
        }
        return Optional.empty();
    }

    /** As {@link #of(String)}, without values. */
    public Optional<String> nameOf(String message) {
        return of(message).map(Meaning::name);
    }

    /** All names. */
    public Set<String> names() {
        Set<String> names = new LinkedHashSet<>();
        rules.forEach(rule -> names.add(rule.name()));
        return names;
    }
}
