package org.evoloop.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/**
 * Who is part of a loop, and how the result of one component reaches the next.
 *
 * <p>Threading: read from any thread; changed only between two occurrences, by one thread at a time.
 */
final class Roster<O, A, P> {
    private final LoopConfig config;
    private final Dispatch<P> dispatch;
    private final Sequencer<O> sequencer;
    private final List<MonitorWorker<O>> monitors = new CopyOnWriteArrayList<>();
    private final List<ExecuteEntry<P>> executes = new CopyOnWriteArrayList<>();
    private volatile List<Execute<P>> executeOrder = List.of();
    private volatile @Nullable StageWorker<O> analyze;
    private volatile @Nullable StageWorker<A> plan;

    private record ExecuteEntry<P>(Execute<P> component, StageWorker<P> worker) {}

    Roster(LoopConfig config, Dispatch<P> dispatch, Sequencer<O> sequencer) {
        this.config = config;
        this.dispatch = dispatch;
        this.sequencer = sequencer;
    }

    Worker enlist(Monitor<O> monitor, int position) {
        MonitorWorker<O> worker = new MonitorWorker<>(monitor, config, sequencer);
        monitors.add(Math.min(position, monitors.size()), worker);
        return worker;
    }

    Worker enlist(Analyze<O, A> component) {
        requireNone(analyze);
        StageWorker<O> worker = new StageWorker<>(
                component,
                config,
                (cycle, occurrence) -> sequencer.passOn(cycle, component.analyze(occurrence), plan),
                sequencer::failed);
        analyze = worker;
        sequencer.setAnalyze(worker);
        return worker;
    }

    Worker enlist(Plan<A, P> component) {
        requireNone(plan);
        StageWorker<A> worker = new StageWorker<>(
                component,
                config,
                (cycle, analysis) -> dispatch(cycle, component.plan(analysis), null),
                sequencer::failed);
        plan = worker;
        return worker;
    }

    Worker enlist(Execute<P> component, int position) {
        StageWorker<P> worker = new StageWorker<>(
                component,
                config,
                (cycle, planned) -> {
                    component.execute(planned);
                    dispatch(cycle, planned, component);
                },
                sequencer::failed);
        executes.add(Math.min(position, executes.size()), new ExecuteEntry<>(component, worker));
        orderExecutes();
        return worker;
    }

    /** Enlists a component of any role; one that was made for another loop fails when it is first called. */
    @SuppressWarnings("unchecked")
    Worker enlistAny(Component component, int position) {
        return switch (component.role()) {
            case MONITOR -> enlist((Monitor<O>) component, position);
            case ANALYZE -> enlist((Analyze<O, A>) component);
            case PLAN -> enlist((Plan<A, P>) component);
            case EXECUTE -> enlist((Execute<P>) component, position);
        };
    }

    private void dispatch(long cycle, @Nullable P planned, @Nullable Execute<P> last) {
        Execute<P> next = planned == null ? null : dispatch.next(planned, executeOrder, last);
        StageWorker<P> worker = null;
        // By index: an iterator would be garbage in every cycle.
        for (int index = 0; index < executes.size(); index++) {
            if (executes.get(index).component() == next) {
                worker = executes.get(index).worker();
            }
        }
        sequencer.passOn(cycle, planned, worker);
    }

    private void orderExecutes() {
        executeOrder = executes.stream().map(ExecuteEntry::component).toList();
    }

    private static void requireNone(@Nullable Worker present) {
        if (present != null) {
            throw new IllegalStateException("there is a component of the role "
                    + present.component().role() + " already, "
                    + present.component().name()
                    + "; exchange it instead");
        }
    }

    /** Takes a component out; its thread is told to end. Returns its position among those of its role. */
    int drop(Worker worker) {
        worker.retire();
        int position = 0;
        switch (worker.component().role()) {
            case MONITOR -> {
                position = monitors.indexOf(worker);
                monitors.remove(position);
            }
            case ANALYZE -> {
                analyze = null;
                sequencer.setAnalyze(null);
            }
            case PLAN -> plan = null;
            case EXECUTE -> {
                position = executes.stream().map(ExecuteEntry::worker).toList().indexOf(worker);
                executes.remove(position);
                orderExecutes();
            }
        }
        return position;
    }

    /** Whether the loop could not go on without this component. */
    boolean needs(Worker worker) {
        return switch (worker.component().role()) {
            case MONITOR -> false;
            case ANALYZE, PLAN -> true;
            case EXECUTE -> executes.size() == 1;
        };
    }

    /** The roles for which a component is missing, as problems. */
    List<String> problems() {
        List<String> problems = new ArrayList<>();
        if (analyze == null) {
            problems.add("no analyze component, exactly 1 is needed");
        }
        if (plan == null) {
            problems.add("no plan component, exactly 1 is needed");
        }
        if (executes.isEmpty()) {
            problems.add("no execute component, at least 1 is needed");
        }
        return problems;
    }

    @Nullable
    MonitorWorker<O> workerOf(Monitor<O> monitor) {
        for (int index = 0; index < monitors.size(); index++) {
            if (monitors.get(index).component() == monitor) {
                return monitors.get(index);
            }
        }
        return null;
    }

    /** Every worker, in the order of the loop. */
    List<Worker> workers() {
        List<Worker> all = new ArrayList<>(monitors);
        for (Worker stage : new Worker[] {analyze, plan}) {
            if (stage != null) {
                all.add(stage);
            }
        }
        executes.forEach(entry -> all.add(entry.worker()));
        return all;
    }

    @Nullable
    Worker find(String name) {
        return workers().stream()
                .filter(worker -> worker.component().name().equals(name))
                .findFirst()
                .orElse(null);
    }

    /** @throws IllegalArgumentException if there is none of that name; the message lists those there are */
    Worker require(String name) {
        Worker worker = find(name);
        if (worker == null) {
            List<String> names = workers().stream()
                    .map(present -> present.component().name())
                    .toList();
            throw new IllegalArgumentException(
                    "no component is named " + name + "; there are " + String.join(", ", names));
        }
        return worker;
    }
}
