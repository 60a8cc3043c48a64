package org.evoloop.models.checking;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.check.Finding;
import org.evoloop.check.TimedEvent;
import org.evoloop.check.timing.Span;
import org.evoloop.models.diagram.Timing;

/** The timed events that lead to a finding, as text and as a picture. */
final class TimedExample {
    private TimedExample() {}

    /** {@code at 0 s start (Off, Off); at 1.5 s Clean -> (On, On)}. */
    static String text(List<TimedEvent> events) {
        List<String> steps = new ArrayList<>();
        for (TimedEvent event : events.subList(0, events.size() - 1)) {
            steps.add("at " + Span.length(event.atNanos()) + " " + event.what() + " -> " + event.after()
                    + (event.step().isEmpty() ? "" : ", sending " + event.step()));
        }
        TimedEvent last = events.get(events.size() - 1);
        steps.add("at " + Span.length(last.atNanos()) + " " + last.what());
        return String.join("; ", steps);
    }

    /** The timing diagram of {@code finding}, which has timed events. */
    static Timing picture(Finding finding) {
        return new Timing(
                finding.rule().id() + ": " + finding.message(),
                List.of("device", "new model", "sent to the device"),
                finding.timed().stream()
                        .map(event -> new Timing.Moment(
                                Span.length(event.atNanos()),
                                event.what(),
                                List.of(
                                        event.after().original().name(),
                                        event.after().evolved().name(),
                                        event.step())))
                        .toList());
    }
}
