package org.evoloop.loop;

import java.util.ArrayList;
import java.util.List;
import org.evoloop.flight.PhaseEvent;
import org.jspecify.annotations.Nullable;

/**
 * The path of an occurrence through the components: analyze, plan, and the execute components that the dispatch
 * chooses, one after another. Each hands its result to the next, which continues on its own thread if it has one.
 *
 * <p>Threading: used by one thread at a time; changed only between two occurrences.
 */
final class Pipeline<O, A, P> {
    private final String loop;
    private final Dispatch<P> dispatch;
    private volatile @Nullable StageWorker<O> analyze;
    private volatile @Nullable StageWorker<A> plan;
    private volatile List<StageWorker<P>> executes = List.of();
    private volatile List<Execute<P>> executeOrder = List.of();

    /** @param loop the loop's name, for recordings */
    Pipeline(String loop, Dispatch<P> dispatch) {
        this.loop = loop;
        this.dispatch = dispatch;
    }

    /** The component with which each occurrence begins; null if there is none yet. */
    @Nullable
    StageWorker<O> first() {
        return analyze;
    }

    StageWorker.Work<O> through(Analyze<O, A> analyzing) {
        return (by, occurrence) -> {
            PhaseEvent phase = PhaseEvent.begun();
            A analysis;
            try {
                A made = analyzing.analyze(occurrence);
                analysis = made == null ? analyzing.unlessDismissed(occurrence) : made;
            } finally {
                PhaseEvent.ended(phase, loop, "analyze", analyzing.name(), occurrence);
            }
            return by.handOn(analysis, plan);
        };
    }

    StageWorker.Work<A> through(Plan<A, P> planning) {
        return (by, analysis) -> {
            PhaseEvent phase = PhaseEvent.begun();
            P planned;
            try {
                P made = planning.plan(analysis);
                planned = made == null ? planning.unlessDismissed(analysis) : made;
            } finally {
                PhaseEvent.ended(phase, loop, "plan", planning.name(), analysis);
            }
            return dispatch(by, planned, null);
        };
    }

    StageWorker.Work<P> through(Execute<P> executing) {
        return (by, planned) -> {
            PhaseEvent phase = PhaseEvent.begun();
            try {
                executing.execute(planned);
            } finally {
                PhaseEvent.ended(phase, loop, "execute", executing.name(), planned);
            }
            return dispatch(by, planned, executing);
        };
    }

    private @Nullable StageWorker<P> dispatch(StageWorker<?> by, @Nullable P planned, @Nullable Execute<P> last) {
        // One that was given up must not ask: the dispatch may be at work for the next occurrence.
        Execute<P> next = planned == null || !by.isWorking() ? null : dispatch.next(planned, executeOrder, last);
        return by.handOn(planned, workerOf(next));
    }

    private @Nullable StageWorker<P> workerOf(@Nullable Execute<P> execute) {
        List<StageWorker<P>> candidates = executes;
        // By index: an iterator would be garbage in every cycle.
        for (int index = 0; index < candidates.size(); index++) {
            if (candidates.get(index).component() == execute) {
                return candidates.get(index);
            }
        }
        return null;
    }

    /** Whether {@code execute} was given up and has not returned. */
    boolean isStuck(Execute<P> execute) {
        StageWorker<P> worker = workerOf(execute);
        return worker != null && worker.isStuck();
    }

    /** Sets the components. */
    @SuppressWarnings("unchecked") // nothing else is enlisted there
    void lead(@Nullable StageWorker<O> nowAnalyze, @Nullable StageWorker<A> nowPlan, List<StageWorker<P>> nowExecutes) {
        analyze = nowAnalyze;
        plan = nowPlan;
        executes = List.copyOf(nowExecutes);
        List<Execute<P>> order = new ArrayList<>();
        for (StageWorker<P> worker : nowExecutes) {
            order.add((Execute<P>) worker.component());
        }
        executeOrder = List.copyOf(order);
    }
}
