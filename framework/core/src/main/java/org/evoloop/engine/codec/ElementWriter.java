package org.evoloop.engine.codec;

import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Step;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.Transition;
import org.jspecify.annotations.Nullable;

/**
 * Writes events, steps, decisions and occurrences as the items that {@link ElementReader} reads, in the same order.
 *
 * <p>Nothing is allocated for an occurrence without values and guards, or for a decision.
 *
 * <p>Threading: not thread-safe.
 *
 * @since 0.1
 */
public final class ElementWriter {
    private final ItemWriter items;

    /** One that writes to {@code items}. */
    public ElementWriter(ItemWriter items) {
        this.items = items;
    }

    /** Writes an event. */
    public ItemWriter event(Event event) {
        return items.name(event.name()).names(event.guards());
    }

    void at(String name, Configuration at) {
        items.begin(name).name(at.original().name()).name(at.evolved().name()).end();
    }

    void transition(String name, @Nullable Transition transition) {
        if (transition == null) {
            items.none(name);
        } else {
            items.beginSome(name);
            arc(transition).end();
        }
    }

    private ItemWriter arc(Transition transition) {
        items.name(transition.source().name());
        event(transition.event());
        return items.name(transition.target().name());
    }

    void step(String name, @Nullable Step step) {
        if (step == null) {
            items.none(name);
        } else {
            items.beginSome(name)
                    .choice(step.byDevice(), "device", "sent")
                    .choice(step.conditional(), "conditional", "always");
            arc(step.transition()).end();
        }
    }

    void steps(List<Step> steps) {
        for (int index = 0; index < steps.size(); index++) {
            step("step", steps.get(index));
        }
    }

    /** Writes a decision, or that there is none. */
    public void decision(@Nullable Decision decision) {
        if (decision == null) {
            items.none("decision");
            return;
        }
        items.beginSome("decision").word(DecisionKind.of(decision).word()).end();
        at("before", decision.before());
        at("after", decision.after());
        transition("transition", decision.transition());
        items.begin("steps").number(decision.steps().size()).end();
        steps(decision.steps());
        items.begin("effects").names(decision.effects()).end();
        items.begin("reason").text(DecisionKind.reasonOf(decision)).end();
    }

    /** Writes an occurrence. */
    public void occurrence(Occurrence occurrence) {
        if (occurrence instanceof Occurrence.Heard heard) {
            kind("heard", occurrence)
                    .number(heard.visit())
                    .word(Constants.SOURCES.word(heard.source()))
                    .choice(heard.deviceActed(), "acted", "told");
            event(heard.event()).names(sorted(heard.holding()));
            values(occurrence);
        } else if (occurrence instanceof Occurrence.Asked asked) {
            kind("asked", occurrence).number(asked.visit());
            event(asked.event());
            values(occurrence);
        } else if (occurrence instanceof Occurrence.Found found) {
            kind("found", occurrence).name(found.state().name());
        } else if (occurrence instanceof Occurrence.InDoubt inDoubt) {
            kind("in-doubt", occurrence).text(inDoubt.why());
        } else if (occurrence instanceof Occurrence.Violated violated) {
            kind("violated", occurrence).text(violated.property());
        } else if (occurrence instanceof Occurrence.Evolved evolved) {
            kind("evolved", occurrence).text(evolved.model());
        }
        items.end();
    }

    private ItemWriter kind(String word, Occurrence occurrence) {
        return items.beginKind(word).number(occurrence.observedNanos());
    }

    private static Collection<String> sorted(Set<String> texts) {
        return texts.size() < 2 ? texts : texts.stream().sorted().toList();
    }

    private void values(Occurrence occurrence) {
        Map<String, Object> values = occurrence.values().byName();
        items.number(values.size());
        if (!values.isEmpty()) {
            values.forEach((name, value) -> items.name(name).value(value));
        }
    }
}
