package org.evoloop.loop;

import static org.openjdk.jcstress.annotations.Expect.ACCEPTABLE;

import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.openjdk.jcstress.annotations.Actor;
import org.openjdk.jcstress.annotations.Arbiter;
import org.openjdk.jcstress.annotations.Expect;
import org.openjdk.jcstress.annotations.JCStressTest;
import org.openjdk.jcstress.annotations.Outcome;
import org.openjdk.jcstress.annotations.State;
import org.openjdk.jcstress.infra.results.III_Result;

/** A thread looks into its slot while it is being filled; if it misses the input, it finds it the next time. */
@JCStressTest
@Outcome(id = "1, 7, 8", expect = ACCEPTABLE, desc = "run once, with its cycle and its input")
@Outcome(expect = Expect.FORBIDDEN, desc = "lost, run twice, or run with less than was given")
@State
public class WholeInputStress {
    private static final Rig RIG = new Rig(ThreadingModel.SINGLE_CARRIER, 1);

    private final Crew crew = new Crew(Rig.config(ThreadingModel.SINGLE_CARRIER, 1));
    private final CarrierThread carrier = Objects.requireNonNull(crew.shared());
    private final StageWorker<Input> stage = new StageWorker<>(new Rig.Nothing(), crew, RIG.sequencer, this::run);
    private int runs;
    private long cycle;
    private int content;

    /** Its field is not final, so that only the slot publishes it. */
    private static final class Input {
        private int content;

        Input(int content) {
            this.content = content;
        }
    }

    private @Nullable StageWorker<?> run(StageWorker<Input> by, Input input) {
        runs++;
        cycle = by.cycle();
        content = input.content;
        return null;
    }

    @Actor
    public void giver() {
        stage.give(7, new Input(8));
    }

    @Actor
    public void runner() {
        carrier.runGiven();
    }

    @Arbiter
    public void afterwards(III_Result result) {
        carrier.runGiven();
        carrier.runGiven();
        result.r1 = runs;
        result.r2 = (int) cycle;
        result.r3 = content;
    }
}
