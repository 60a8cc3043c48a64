package org.evoloop.mqtt.home;

import java.util.ArrayDeque;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.evoloop.converter.ConverterStatus;
import org.evoloop.converter.SystemEventConverter;
import org.evoloop.evolution.EventOutcome;
import org.evoloop.evolution.ModelPair;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.jspecify.annotations.Nullable;

/**
 * Presses what a command of an entity takes, one event after another: the next one when the outcome of the last is known.
 *
 * <p>Threading: not thread-safe.
 */
final class HomeOperator {
    private static final int MOST_WAITING = 64;
    private static final EventOutcome NONE = new EventOutcome.Refused("nothing was pressed");

    private final SystemEventConverter converter;
    private final Function<String, CompletableFuture<EventOutcome>> submit;
    private final BiConsumer<String, String> refused;
    private final Deque<Waiting> waiting = new ArrayDeque<>();
    private @Nullable Errand errand;
    private String purpose = "";
    private CompletableFuture<EventOutcome> pressed = CompletableFuture.completedFuture(NONE);

    private record Waiting(HomeEntity entity, String command) {}

    /**
     * @param submit presses an event
     * @param refused is told a command and why it was not carried out
     */
    HomeOperator(
            SystemEventConverter converter,
            Function<String, CompletableFuture<EventOutcome>> submit,
            BiConsumer<String, String> refused) {
        this.converter = converter;
        this.submit = submit;
        this.refused = refused;
    }

    /** The names of the events that a controller may raise. */
    Set<String> buttons() {
        return converter.controllerEvents().stream()
                .map(Event::name)
                .collect(Collectors.toCollection(LinkedHashSet::new));
    }

    HomeTable table(HomeEntity entity) {
        return HomeTable.of(entity, models(), buttons());
    }

    private ModelPair models() {
        return converter.knowledge().models();
    }

    /** What an entity shows; empty if that is not known. */
    static String shown(HomeEntity entity, HomeTable table, ConverterStatus status) {
        String byState = table.shown(status.states().evolved());
        String shown = entity.hooks().shown(status, byState.isEmpty() ? null : byState);
        return shown == null ? "" : shown;
    }

    /** Obeys a command, after those that came before it. */
    void obey(HomeEntity entity, String command) {
        if (waiting.size() >= MOST_WAITING) {
            throw new IllegalStateException("more than " + MOST_WAITING + " commands wait");
        }
        waiting.add(new Waiting(entity, command));
        proceed();
    }

    private void begin(Waiting next) throws Exception {
        HomeEntity entity = next.entity();
        ConverterStatus status = converter.status();
        if (!entity.hooks().begins(next.command(), status)) {
            errand = null;
            return;
        }
        HomeTable table = table(entity);
        HomeTable.Decision decided =
                table.decide(status.states().evolved(), next.command(), shown(entity, table, status));
        Way way = decided.way();
        if (way != null) {
            begin(way, decided.goals(), entity + " " + next.command());
            return;
        }
        if (decided.deed() != HomeTable.Deed.NOTHING) {
            throw new IllegalStateException(
                    decided.text() + " (state " + status.states().evolved() + ")");
        }
        errand = null;
    }

    private void begin(Way way, Collection<State> goals, String what) {
        Errand begun = new Errand(way, goals, this::press, converter.clock().nanoTime());
        errand = null;
        purpose = what;
        if (step(begun)) {
            errand = begun;
        }
    }

    private void press(String event) {
        pressed = submit.apply(event);
    }

    private boolean step(Errand begun) {
        return begun.step(
                converter.status().states().evolved(), converter.clock().nanoTime());
    }

    /** Goes on, if the outcome of the last press is known. */
    void proceed() {
        settle();
        while (pressed.isDone()) {
            Waiting next = waiting.poll();
            if (next == null) {
                break;
            }
            attempt(next.entity() + " " + next.command(), () -> begin(next));
            settle();
        }
        Errand begun = errand;
        if (begun != null && pressed.isDone()) {
            errand = null;
            attempt(purpose, () -> errand = step(begun) ? begun : null);
            settle();
        }
    }

    /** A press that had no effect ends the work. */
    private void settle() {
        EventOutcome outcome = pressed.getNow(NONE);
        if (!outcome.isHandled() && !outcome.equals(NONE)) {
            pressed = CompletableFuture.completedFuture(NONE);
            errand = null;
            refused.accept(purpose, outcome.why());
        }
    }

    private interface Attempt {
        void run() throws Exception;
    }

    private void attempt(String what, Attempt attempt) {
        try {
            attempt.run();
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        } catch (Exception refusal) {
            refused.accept(what, String.valueOf(refusal.getMessage()));
        }
    }
}
