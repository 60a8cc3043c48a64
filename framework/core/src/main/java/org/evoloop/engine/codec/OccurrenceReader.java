package org.evoloop.engine.codec;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;

/** Reads occurrences. An event need not be one of the models': any may have been reported. */
final class OccurrenceReader {
    private final Items items;
    private final Names names;

    OccurrenceReader(Items items, Names names) {
        this.items = items;
        this.names = names;
    }

    Occurrence read() {
        String kind = items.next();
        long observedNanos = items.number();
        Occurrence read = switch (kind) {
            case "heard" -> heard(observedNanos);
            case "asked" -> asked(observedNanos);
            case "found" -> new Occurrence.Found(names.originalState(), observedNanos);
            case "evolved" -> new Occurrence.Evolved(items.text(), observedNanos);
            case "violated" -> new Occurrence.Violated(items.text(), observedNanos);
            case "in-doubt" -> new Occurrence.InDoubt(items.text(), observedNanos);
            default -> throw items.damaged("'" + kind + "' is not an occurrence");
        };
        items.ends();
        return read;
    }

    private Occurrence heard(long observedNanos) {
        long visit = items.total();
        Source source = Constants.SOURCES.read(items);
        boolean acted = items.choice("acted", "told");
        Event event = names.event();
        List<String> texts = items.texts();
        Set<String> holding = texts.isEmpty() ? Set.of() : new TreeSet<>(texts);
        return new Occurrence.Heard(event, values(), source, acted, holding, visit, observedNanos);
    }

    private Occurrence asked(long observedNanos) {
        long visit = items.total();
        return new Occurrence.Asked(names.event(), values(), visit, observedNanos);
    }

    private Values values() {
        int count = items.count();
        if (count == 0) {
            return Values.NONE;
        }
        Map<String, Object> byName = new TreeMap<>();
        for (int read = 0; read < count; read++) {
            byName.put(items.text(), items.value());
        }
        return new Values(byName);
    }
}
