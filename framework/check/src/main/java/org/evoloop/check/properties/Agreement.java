package org.evoloop.check.properties;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.evoloop.check.timing.Assumption;
import org.evoloop.check.timing.Reaction;
import org.evoloop.check.timing.Span;
import org.evoloop.check.timing.TimeForm;
import org.evoloop.check.timing.TimeProperty;

/** Checks that the lines about time do not contradict each other. */
final class Agreement {
    private final String file;
    private final List<TimeProperty> properties = new ArrayList<>();
    private final Map<Reaction, Integer> reactions = new LinkedHashMap<>();
    private final Map<Object, Integer> lines = new HashMap<>();
    private final List<String> problems = new ArrayList<>();

    Agreement(String file) {
        this.file = file;
    }

    void add(Assumption assumption, int line) {
        Integer other = lines.putIfAbsent(assumption.about(), line);
        if (other != null) {
            add(line, "line " + other + " already says how long that is; remove one of the two");
        }
    }

    void add(Reaction reaction, int line) {
        Integer other = lines.putIfAbsent("violation of " + reaction.property(), line);
        if (other != null) {
            add(line, "line " + other + " already says what is raised then; remove one of the two");
        }
        reactions.put(reaction, line);
    }

    void add(TimeProperty property) {
        for (TimeProperty other : properties) {
            if (other.name().equals(property.name())) {
                add(
                        property.line(),
                        "line " + other.line() + " has the name '" + other.name() + "', too; give one of them another");
            }
            contradiction(property.form(), other.form())
                    .or(() -> contradiction(other.form(), property.form()))
                    .ifPresent(why -> add(
                            property.line(),
                            "this contradicts line " + other.line() + ": " + why + "; change one of them"));
        }
        properties.add(property);
    }

    private static Optional<String> contradiction(TimeForm one, TimeForm other) {
        if (one instanceof TimeForm.Stay longest && other instanceof TimeForm.Stay shortest) {
            return longest.subject().equals(shortest.subject())
                    ? empty(shortest.span().minNanos(), longest.span().maxNanos())
                    : Optional.empty();
        } else if (one instanceof TimeForm.Stay longest && other instanceof TimeForm.Before before) {
            return longest.subject().equals(before.other())
                    ? empty(before.minNanos(), longest.span().maxNanos())
                    : Optional.empty();
        } else if (one instanceof TimeForm.Response first && other instanceof TimeForm.Response second) {
            boolean same =
                    first.subject().equals(second.subject()) && first.other().equals(second.other());
            return same ? empty(second.span().minNanos(), first.span().maxNanos()) : Optional.empty();
        }
        return Optional.empty();
    }

    private static Optional<String> empty(long least, long most) {
        return least > most
                ? Optional.of("nothing takes at least " + Span.length(least) + " and at most " + Span.length(most))
                : Optional.empty();
    }

    private void add(int line, String problem) {
        problems.add(file + ", line " + line + ": " + problem);
    }

    List<String> problems() {
        reactions.forEach((reaction, line) -> {
            if (properties.stream().noneMatch(each -> each.name().equals(reaction.property()))) {
                add(
                        line,
                        "no time property is named '" + reaction.property() + "'; there "
                                + (properties.isEmpty() ? "is none" : "are " + names()));
            }
        });
        return problems;
    }

    private String names() {
        return String.join(", ", properties.stream().map(TimeProperty::name).toList());
    }
}
