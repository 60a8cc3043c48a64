package org.evoloop.core.text;

import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;

/** Reads the lines of occurrences. An event need not be one of the models': any may have been reported. */
final class OccurrenceReader {
    private final Lines lines;
    private final Names names;

    OccurrenceReader(Lines lines, Names names) {
        this.lines = lines;
        this.names = names;
    }

    Occurrence read() {
        String kind = lines.next();
        long observedNanos = lines.number();
        Occurrence read = switch (kind) {
            case "heard" -> heard(observedNanos);
            case "asked" -> asked(observedNanos);
            case "found" -> new Occurrence.Found(names.originalState(), observedNanos);
            case "evolved" -> new Occurrence.Evolved(lines.text(), observedNanos);
            case "violated" -> new Occurrence.Violated(lines.text(), observedNanos);
            case "in-doubt" -> new Occurrence.InDoubt(lines.text(), observedNanos);
            default -> throw lines.damaged("'" + kind + "' is not an occurrence");
        };
        lines.ends();
        return read;
    }

    private Occurrence heard(long observedNanos) {
        long visit = lines.total();
        Source source = source();
        boolean acted = lines.choice("acted", "told");
        Event event = names.event();
        Set<String> holding = new TreeSet<>(lines.texts());
        return new Occurrence.Heard(event, values(), source, acted, holding, visit, observedNanos);
    }

    private Occurrence asked(long observedNanos) {
        long visit = lines.total();
        return new Occurrence.Asked(names.event(), values(), visit, observedNanos);
    }

    private Source source() {
        String word = lines.word();
        for (Source source : Source.values()) {
            if (source.name().toLowerCase(Locale.ROOT).equals(word)) {
                return source;
            }
        }
        throw lines.damaged("'" + word + "' is not a source of events");
    }

    private Values values() {
        int count = lines.count();
        Map<String, Object> byName = new TreeMap<>();
        for (int read = 0; read < count; read++) {
            byName.put(lines.text(), value());
        }
        return count == 0 ? Values.NONE : new Values(byName);
    }

    private Object value() {
        if (lines.isQuotedNext()) {
            return lines.text();
        }
        String word = lines.word();
        if (word.equals("true") || word.equals("false")) {
            return word.equals("true");
        }
        try {
            return Double.valueOf(word);
        } catch (NumberFormatException e) {
            throw lines.damaged("'" + word + "' is no value");
        }
    }
}
