package org.evoloop.converter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.evoloop.Machines.machine;
import static org.evoloop.converter.Robot.at;

import java.io.IOException;
import java.util.Set;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.OnFailure;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Step;
import org.evoloop.loop.LoopConfig;
import org.evoloop.time.ManualClock;
import org.junit.jupiter.api.Test;

/** One component could not send a step, and another one tries another way. */
class OtherSenderTest {
    private static final ModelPair MODELS = new ModelPair(
            machine("door", "Shut push -> Open", "Shut pull -> Open", "Open pull -> Shut"),
            machine("new", "Shut go -> Open", "Shut push -> Open", "Shut pull -> Open", "Open pull -> Shut"));

    private abstract static class Arm extends EventExecute {
        Arm(String name) {
            super(name);
        }

        @Override
        protected Set<String> sendableEvents() {
            return Set.of(name());
        }

        void claimsTheEffect() {
            tookEffect();
        }
    }

    @Test
    void aReportOfTheFirstIsNotTakenForTheEffectOfTheSecond() throws InterruptedException {
        Arm push = new Arm("push") {
            @Override
            protected void send(Step step) throws IOException {
                throw new IOException("too weak");
            }
        };
        Arm pull = new Arm("pull") {
            @Override
            protected void send(Step step) throws IOException {
                push.claimsTheEffect();
                throw new IOException("no grip");
            }
        };
        try (SystemEventConverter converter = new SystemEventConverter(
                LoopConfig.defaults("door", new ManualClock()).withoutThreads())) {
            PushMonitor remote = new PushMonitor("Remote");
            converter.addMonitor(remote);
            converter.addExecute(push);
            converter.addExecute(pull);
            converter.addKnowledge(new StateKnowledge(MODELS) {
                @Override
                protected void registerNewFunctions() {
                    onFailure("Shut", "go", OnFailure.OTHER_WAY);
                }
            });
            converter.build();
            converter.start();
            remote.press("go");
            converter.observe(remote);
            while (converter.step()) {
                // One attempt after the other.
            }
            HistoryEntry last = converter.history().get(converter.history().size() - 1);
            assertThat(last.outcome()).isEqualTo(Outcome.FAILED);
            assertThat(converter.knowledge().configuration()).isEqualTo(at("Shut", "Shut"));
        }
    }
}
