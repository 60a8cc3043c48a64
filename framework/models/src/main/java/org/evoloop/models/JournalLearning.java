package org.evoloop.models;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import org.evoloop.converter.Drift;
import org.evoloop.journal.JournalFiles;
import org.evoloop.statemachine.StateMachine;
import org.jspecify.annotations.Nullable;

/** Proposes a machine, or additions to a declared one, from journals, and says how often each transition was seen. */
final class JournalLearning {
    private final Recorded recorded = new Recorded();
    private final PrintWriter out;

    JournalLearning(List<Path> journals, PrintWriter out) {
        this.out = out;
        journals.forEach(each -> recorded.read(new JournalFiles(each)));
    }

    /** What was seen, one line for each transition. */
    List<String> seen() {
        return recorded.edges().stream().map(JournalLearning::line).toList();
    }

    /** Whether every event led to one state only. */
    boolean isClear() {
        return recorded.ambiguous().isEmpty();
    }

    /** The proposal, which is explained; null if nothing was seen. */
    @Nullable
    StateMachine propose(@Nullable StateMachine declared, String name) {
        seen().forEach(out::println);
        StateMachine machine;
        if (declared == null) {
            machine = recorded.machine(name);
        } else {
            Drift additions = recorded.additions(declared);
            additions.edges().forEach(edge -> out.println("added: " + line(edge)));
            machine = additions.explained(declared);
        }
        recorded.ambiguous().forEach(edge -> out.println("open: " + edge + ": also led elsewhere"));
        if (machine == null) {
            out.println("open: no act of the device is recorded after which it said where it is");
        }
        out.flush();
        return machine;
    }

    private static String line(Drift.Edge edge) {
        String times = edge.count() == 1 ? "once" : edge.count() + " times";
        return edge.target() == null
                ? edge + ": " + times + ", and the device did not say where that led"
                : edge + ": seen " + times;
    }
}
