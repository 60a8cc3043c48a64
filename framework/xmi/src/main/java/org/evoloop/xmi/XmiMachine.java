package org.evoloop.xmi;

import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.Optional;
import org.evoloop.statechart.Flattening;
import org.evoloop.statechart.Statechart;
import org.evoloop.statechart.TimeUnits;
import org.evoloop.statemachine.ModelException;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.dialect.DrawnMachine;
import org.evoloop.xmi.dialect.Problems;
import org.jspecify.annotations.Nullable;

/**
 * One state machine of an {@link ModelFile}, not checked yet.
 *
 * <p>Threading: immutable.
 *
 * @since 0.1
 */
public final class XmiMachine {
    private final String file;
    private final DrawnMachine drawn;
    private final @Nullable ChronoUnit timeUnit;

    XmiMachine(String file, DrawnMachine drawn) {
        this(file, drawn, null);
    }

    private XmiMachine(String file, DrawnMachine drawn, @Nullable ChronoUnit timeUnit) {
        this.file = file;
        this.drawn = drawn;
        this.timeUnit = timeUnit;
    }

    XmiMachine withTimeUnit(ChronoUnit unit) {
        return new XmiMachine(file, drawn, unit);
    }

    /** The {@code xmi.id}, unique in a file written by its tool; empty if the file has none. */
    public String id() {
        return drawn.id();
    }

    /** The machine's own name, often a default of the tool such as {@code StateMachine0}; may be empty. */
    public String machineName() {
        return drawn.name();
    }

    /** The name of the diagram that shows the machine, which is the name its author sees; empty if there is none. */
    public Optional<String> diagramName() {
        return drawn.diagramName().filter(name -> !name.isEmpty());
    }

    /** The machine's first line in the file, counted from 1. */
    public int line() {
        return drawn.line();
    }

    /** Its name in messages: the diagram name, else the machine's own name, else its id. */
    public String name() {
        return diagramName().orElse(machineName().isEmpty() ? id() : machineName());
    }

    /** Whether {@code name} is the diagram name, the machine's own name or the id. */
    public boolean answersTo(String name) {
        return name.equals(id())
                || name.equals(machineName())
                || diagramName().filter(name::equals).isPresent();
    }

    /**
     * The machine as drawn, with its hierarchy.
     *
     * @throws ModelException if it contains anything that would be ignored; the message lists everything, one line each
     */
    public Statechart statechart() {
        Problems problems = new Problems();
        Statechart chart = drawn.statechart(name(), problems);
        require(problems);
        return timeUnit == null ? chart : TimeUnits.add(chart, timeUnit);
    }

    /**
     * Notes for its author on a readable machine, one line each: how something was interpreted, or that it has no
     * meaning.
     */
    public List<String> notes() {
        Problems problems = new Problems();
        DefaultGuards.note(drawn.statechart(name(), problems), problems);
        return problems.notes().stream().map(note -> file + ": " + note).toList();
    }

    /**
     * The machine as (E, S, T): the flattened {@link #statechart}.
     *
     * @throws ModelException as in {@link #statechart}, and if the machine has no flat equivalent; the message lists
     *     all problems, one line each
     */
    public StateMachine toStateMachine() {
        return flattening().machine();
    }

    /**
     * The machine as (E, S, T), and how its states correspond to the drawn ones.
     *
     * @throws ModelException as in {@link #toStateMachine}
     */
    public Flattening flattening() {
        Flattening flattening = Flattening.of(statechart());
        Problems problems = new Problems();
        flattening.problems().forEach(problem -> problems.add(problem.place(), problem.text()));
        require(problems);
        return flattening;
    }

    private void require(Problems problems) {
        if (!problems.isEmpty()) {
            throw new ModelException(file + ": state machine " + Problems.label(name(), id()) + " (line " + line()
                    + ") has "
                    + (problems.count() == 1
                            ? "a problem: " + problems.toString().strip()
                            : problems.count() + " problems:" + problems));
        }
    }
}
