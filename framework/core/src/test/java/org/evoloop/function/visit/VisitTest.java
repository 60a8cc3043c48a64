package org.evoloop.function.visit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.evoloop.function.StatePatternFunction;
import org.evoloop.statemachine.State;
import org.junit.jupiter.api.Test;

class VisitTest {
    private final VisitLog log = new VisitLog(false);
    private final HostedVisit visit = log.visit();
    private final List<String> endings = new ArrayList<>();

    @Test
    void aFunctionMayAskWhichEventsItsStateAccepts() {
        log.accepted.add("timeout");
        assertThat(visit.accepts("timeout")).isTrue();
        assertThat(visit.accepts("arriveSpot")).isFalse();
    }

    @Test
    void aFunctionThatWasLeftBeforeItsThreadRanNeverRuns() {
        visit.end();
        visit.run(running -> {
            throw new AssertionError("it runs beside the next visit");
        });
        assertThat(log.failures).isEmpty();
    }

    @Test
    void anEventThatTheStateDoesNotKnowIsTheFunctionsFailureAndDoesNotEndIt() {
        log.unexpected.add("arriveSpt");
        visit.run(running -> {
            running.finish("arriveSpt");
            assertThat(log.failures)
                    .singleElement()
                    .hasToString("java.lang.IllegalArgumentException: Move does not know arriveSpt");
            running.finish("arriveSpot");
        });
        assertThat(log.events).containsExactly("finished arriveSpot");
        assertThatThrownBy(() -> visit.finishAfter(Duration.ofSeconds(1), "arriveSpt"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("Move does not know arriveSpt");
    }

    @Test
    void onlyTheFirstFinishCounts() {
        visit.finish("arriveSpot");
        visit.finish("timeout");
        visit.finishAfter(Duration.ofSeconds(1), "timeout");
        log.clock.advance(Duration.ofSeconds(2));
        assertThat(log.events).containsExactly("finished arriveSpot");
        assertThat(log.notices)
                .containsExactly(
                        "***  Send arriveSpot event to EventConverter.  ***  ", "***  Stop new functions  ***");
    }

    @Test
    void whatFinishesWithinTheFunctionIsReportedWhenItHasReturned() {
        visit.run(running -> {
            running.finish("arriveSpot");
            assertThat(log.events).isEmpty();
            running.say("Arrive at target point");
        });
        assertThat(log.events).containsExactly("finished arriveSpot");
        assertThat(log.notices)
                .containsExactly(
                        "***  Arrive at target point  ***  ",
                        "***  Send arriveSpot event to EventConverter.  ***  ",
                        "***  Stop new functions  ***");
    }

    @Test
    void aFunctionMayRaiseAsManyEventsAsItLikesBeforeItsLast() throws InterruptedException {
        visit.raise("halfway");
        visit.raise("halfway");
        visit.finish("arriveSpot");
        assertThat(log.events).containsExactly("raised halfway", "raised halfway", "finished arriveSpot");
    }

    @Test
    void finishAfterWaitsAndIsCalledOffWhenTheStateIsLeft() {
        visit.finishAfter(Duration.ofSeconds(5), "timeout");
        log.clock.advance(Duration.ofMillis(4_999));
        assertThat(log.events).isEmpty();
        log.clock.advance(Duration.ofMillis(1));
        assertThat(log.events).containsExactly("finished timeout");

        HostedVisit left = log.visit();
        left.finishAfter(Duration.ofSeconds(5), "timeout");
        left.end();
        assertThat(log.clock.pendingTasks()).isZero();
        log.clock.advance(Duration.ofSeconds(5));
        assertThat(log.events).hasSize(1);
    }

    @Test
    void nothingIsReceivedFromAVisitThatIsOver() throws InterruptedException {
        visit.end();
        visit.raise("halfway");
        visit.finish("arriveSpot");
        visit.finishAfter(Duration.ofSeconds(1), "timeout");
        visit.say("still here");
        visit.after(Duration.ZERO, () -> log.events.add("after"));
        log.clock.advance(Duration.ofSeconds(1));
        assertThat(visit.isActive()).isFalse();
        assertThat(log.events).isEmpty();
        assertThat(log.notices).isEmpty();
        assertThat(log.clock.pendingTasks()).isZero();
    }

    @Test
    void aStateThatIsLeftDuringTheFunctionMakesItsLastEventVoid() {
        visit.run(running -> {
            running.finish("arriveSpot");
            visit.end();
        });
        assertThat(log.events).isEmpty();
        assertThat(log.notices).isEmpty();
    }

    @Test
    void endingsRunOnceTheLastFirst() {
        visit.onEnd(() -> endings.add("first"));
        visit.onEnd(() -> endings.add("second"));
        assertThat(endings).isEmpty();
        visit.end();
        visit.end();
        assertThat(endings).containsExactly("second", "first");
        visit.onEnd(() -> endings.add("late, so at once"));
        assertThat(endings).endsWith("late, so at once");
    }

    @Test
    void anEndingThatThrowsIsReportedAndTheOthersRun() {
        IllegalStateException cause = new IllegalStateException("cannot stop the wheels");
        StackOverflowError worse = new StackOverflowError();
        visit.onEnd(() -> endings.add("wheels"));
        visit.onEnd(() -> {
            throw worse;
        });
        visit.onEnd(() -> endings.add("camera"));
        visit.onEnd(() -> {
            throw cause;
        });
        visit.end();
        assertThat(endings).containsExactly("camera", "wheels");
        assertThat(log.failures).containsExactly(cause, worse);
    }

    @Test
    void aFunctionThatSaysThatItFailsIsReportedAndContinues() {
        visit.run(running -> {
            running.failed("not found");
            running.finish("timeout");
        });
        assertThat(log.failures)
                .singleElement()
                .satisfies(cause -> assertThat(cause).hasMessage("not found"));
        assertThat(log.events).containsExactly("finished timeout");
        visit.end();
        visit.failed("too late");
        assertThat(log.failures).hasSize(1);
    }

    @Test
    void aFunctionThatThrowsIsReportedUnlessItWasInterruptedBecauseItsStateWasLeft() {
        visit.run(running -> {
            throw new InterruptedException("for no reason");
        });
        assertThat(log.failures).hasSize(1);
        HostedVisit left = log.visit();
        left.run(running -> {
            left.end();
            throw new InterruptedException();
        });
        assertThat(log.failures).hasSize(1);
        log.visit().run(running -> {
            throw new AssertionError("a bug");
        });
        assertThat(log.failures).hasSize(2);
    }

    @Test
    void describesItself() {
        assertThat(visit).hasToString("visit 1 of Move");
        assertThat(visit.state()).isEqualTo(new State("Move"));
        assertThat(visit.clock()).isSameAs(log.clock);
        assertThat(visit.threads()).isFalse();
    }

    @Test
    void theSubStatesOfACompositeFollowOneAnother() {
        List<String> passed = new ArrayList<>();
        StatePatternFunction.SubState arrive = running -> {
            passed.add("arrive");
            running.finish("arriveSpot");
            return null;
        };
        StatePatternFunction.SubState[] turn = new StatePatternFunction.SubState[1];
        turn[0] = running -> {
            passed.add("turn");
            return passed.size() < 3 ? turn[0] : arrive;
        };
        StatePatternFunction composite = new StatePatternFunction(turn[0]);
        visit.run(composite);
        assertThat(passed).containsExactly("turn", "turn", "turn", "arrive");
        assertThat(log.events).containsExactly("finished arriveSpot");
    }

    @Test
    void aCompositeThatIsLeftPassesThroughNoFurtherSubState() {
        List<String> passed = new ArrayList<>();
        visit.run(new StatePatternFunction(running -> {
            passed.add("drive");
            visit.end();
            return next -> {
                throw new AssertionError("the state has been left");
            };
        }));
        assertThat(passed).containsExactly("drive");
        assertThat(log.failures).isEmpty();
        assertThatThrownBy(() -> new StatePatternFunction(running -> {
                            throw new IllegalStateException("stuck");
                        })
                        .run(log.visit()))
                .hasMessage("stuck");
    }
}
