package org.evoloop.loop;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The way of an occurrence through the loop: analyze, plan, and one execute component after the other that the dispatch
 * names. Each hands its result to the next by way of the sequencer, which says whose turn it is.
 *
 * <p>Threading: walked by one thread at a time; changed only between two occurrences.
 */
final class Passage<O, A, P> {
    private final Dispatch<P> dispatch;
    private final Sequencer<O> sequencer;
    private volatile @Nullable StageWorker<A> plan;
    private volatile List<StageWorker<P>> executes = List.of();
    private volatile List<Execute<P>> executeOrder = List.of();

    Passage(Dispatch<P> dispatch, Sequencer<O> sequencer) {
        this.dispatch = dispatch;
        this.sequencer = sequencer;
    }

    StageWorker.Work<O> through(Analyze<O, A> analyze) {
        return (by, occurrence) -> sequencer.passOn(by, analyze.analyze(occurrence), plan);
    }

    StageWorker.Work<A> through(Plan<A, P> planning) {
        return (by, analysis) -> dispatch(by, planning.plan(analysis), null);
    }

    StageWorker.Work<P> through(Execute<P> execute) {
        return (by, planned) -> {
            execute.execute(planned);
            return dispatch(by, planned, execute);
        };
    }

    private @Nullable StageWorker<P> dispatch(StageWorker<?> by, @Nullable P planned, @Nullable Execute<P> last) {
        Execute<P> next = planned == null ? null : dispatch.next(planned, executeOrder, last);
        List<StageWorker<P>> candidates = executes;
        StageWorker<P> worker = null;
        // By index: an iterator would be garbage in every cycle.
        for (int index = 0; index < candidates.size(); index++) {
            if (candidates.get(index).component() == next) {
                worker = candidates.get(index);
            }
        }
        return sequencer.passOn(by, planned, worker);
    }

    /** From now on it leads through these. */
    @SuppressWarnings("unchecked") // nothing else is enlisted there
    void lead(@Nullable StageWorker<O> nowAnalyze, @Nullable StageWorker<A> nowPlan, List<StageWorker<P>> nowExecutes) {
        sequencer.setAnalyze(nowAnalyze);
        plan = nowPlan;
        executes = List.copyOf(nowExecutes);
        List<Execute<P>> order = new ArrayList<>();
        for (StageWorker<P> worker : nowExecutes) {
            order.add((Execute<P>) worker.component());
        }
        executeOrder = List.copyOf(order);
    }
}
