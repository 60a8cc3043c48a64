package org.evoloop.loop;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/**
 * The components of a loop.
 *
 * <p>Threading: read from any thread; changed only between two occurrences, by one thread at a time.
 */
final class Roster<O, A, P> {
    private final LoopConfig config;
    private final Pipeline<O, A, P> pipeline;
    private final Sequencer<O> sequencer;
    private final Crew crew;

    /** Replaced as a whole: whoever looks through it misses none while another is added or removed. */
    private volatile List<MonitorWorker<O>> monitors = List.of();

    private final List<StageWorker<P>> executes = new CopyOnWriteArrayList<>();
    private volatile @Nullable StageWorker<O> analyze;
    private volatile @Nullable StageWorker<A> plan;

    Roster(LoopConfig config, Pipeline<O, A, P> pipeline, Sequencer<O> sequencer) {
        this.config = config;
        this.pipeline = pipeline;
        this.sequencer = sequencer;
        this.crew = new Crew(config);
    }

    /**
     * Adds a component of any role; one made for a loop of other types fails when it is first called.
     *
     * @param position its position among those of its role, if there may be several
     */
    @SuppressWarnings("unchecked")
    Worker enlist(Component component, int position) {
        if (component instanceof Monitor) {
            MonitorWorker<O> worker = new MonitorWorker<>((Monitor<O>) component, config, sequencer, crew);
            List<MonitorWorker<O>> more = new ArrayList<>(monitors);
            more.add(Math.min(position, more.size()), worker);
            monitors = List.copyOf(more);
            return worker;
        }
        Worker worker;
        if (component instanceof Analyze) {
            requireNone(analyze);
            worker = analyze = stage(component, pipeline.through((Analyze<O, A>) component));
        } else if (component instanceof Plan) {
            requireNone(plan);
            worker = plan = stage(component, pipeline.through((Plan<A, P>) component));
        } else {
            StageWorker<P> execute = stage(component, pipeline.through((Execute<P>) component));
            executes.add(Math.min(position, executes.size()), execute);
            worker = execute;
        }
        pipeline.lead(analyze, plan, executes);
        return worker;
    }

    private <I> StageWorker<I> stage(Component component, StageWorker.Work<I> work) {
        return new StageWorker<>(component, crew, sequencer, work);
    }

    private static void requireNone(@Nullable Worker present) {
        if (present != null) {
            throw new IllegalStateException("there is a component of the role "
                    + present.component().role() + " already, "
                    + present.component().name()
                    + "; exchange it instead");
        }
    }

    /** Whether the caller is a thread that calls one of the components, or one that was given up or removed. */
    boolean ownsCurrentThread() {
        return crew.ownsCurrentThread();
    }

    /** Starts every thread. */
    void start() {
        crew.start();
        workers().forEach(Worker::start);
    }

    /** Asks every thread to end. */
    void retire() {
        workers().forEach(Worker::retire);
        crew.retire();
    }

    /** The threads that {@link #retire} has asked to end. */
    List<LoopThread> threads() {
        List<LoopThread> all = new ArrayList<>();
        for (Worker worker : workers()) {
            addIfPresent(all, worker.threadToEnd());
        }
        addIfPresent(all, crew.shared());
        return all;
    }

    private static <T> void addIfPresent(List<? super T> list, @Nullable T element) {
        if (element != null) {
            list.add(element);
        }
    }

    /** Removes a component and asks its own thread to end. Returns its position among those of its role. */
    int drop(Worker worker) {
        worker.retire();
        int position = 0;
        if (worker instanceof MonitorWorker) {
            List<MonitorWorker<O>> fewer = new ArrayList<>(monitors);
            position = fewer.indexOf(worker);
            fewer.remove(position);
            monitors = List.copyOf(fewer);
        } else if (worker == analyze) {
            analyze = null;
        } else if (worker == plan) {
            plan = null;
        } else {
            position = executes.indexOf(worker);
            executes.remove(position);
        }
        pipeline.lead(analyze, plan, executes);
        return position;
    }

    /** Whether the loop cannot run without this component. */
    boolean needs(Worker worker) {
        return worker == analyze || worker == plan || executes.equals(List.of(worker));
    }

    /** A problem for each role without a component. */
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
        List<MonitorWorker<O>> present = monitors;
        // By index: an iterator would be garbage in every event.
        for (int index = 0; index < present.size(); index++) {
            if (present.get(index).component() == monitor) {
                return present.get(index);
            }
        }
        return null;
    }

    /** Every worker, in the order of the loop. */
    List<Worker> workers() {
        List<Worker> all = new ArrayList<>(monitors);
        addIfPresent(all, analyze);
        addIfPresent(all, plan);
        all.addAll(executes);
        return all;
    }

    @Nullable
    Worker find(String name) {
        for (Worker worker : workers()) {
            if (worker.component().name().equals(name)) {
                return worker;
            }
        }
        return null;
    }

    /** @throws IllegalArgumentException if there is none of that name; the message lists the names */
    Worker require(String name) {
        Worker worker = find(name);
        if (worker == null) {
            List<String> names = new ArrayList<>();
            for (Worker present : workers()) {
                names.add(present.component().name());
            }
            throw new IllegalArgumentException(
                    "no component is named " + name + "; there are " + String.join(", ", names));
        }
        return worker;
    }
}
