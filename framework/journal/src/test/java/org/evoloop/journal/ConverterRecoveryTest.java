package org.evoloop.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.LongStream;
import org.evoloop.converter.HistoryEntry;
import org.evoloop.evolution.Occurrence;
import org.evoloop.function.Visit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A converter continues where the previous process was killed. */
class ConverterRecoveryTest {
    private static final String ENDED = "the converter's process ended meanwhile";

    @TempDir
    private Path directory;

    private Robots robot;

    @BeforeEach
    void start() throws Exception {
        robot = new Robots(directory);
        robot.converter.start();
    }

    @AfterEach
    void close() {
        robot.close();
    }

    @Test
    void whatWaitedStillWaitsAndTheRecordIsWhereItWas() throws Exception {
        robot.press("Clean");
        robot.settle();
        robot.press("Clean");
        robot.press("Clean");
        robot.copyAndRevive();

        assertThat(robot.states()).isEqualTo("(On, On)");
        assertThat(robot.converter.status().queue().depth()).isEqualTo(2);
        assertThat(robot.outcomes()).as("the history of the previous process").containsExactly("Clean HANDLED");
        robot.converter.start();
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, SpotWait)");
        assertThat(robot.sent).containsExactly("Clean", "Clean");
        assertThat(robot.outcomes()).containsExactly("Clean HANDLED", "Clean HANDLED", "Clean HANDLED");
    }

    @Test
    void aVisitThatAnotherProcessGoesOnWithIsResumed() throws Exception {
        for (int press = 0; press < 3; press++) {
            robot.press("Clean");
            robot.settle();
        }
        robot.copyAndRevive();
        robot.converter.start();
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, SpotWait)");

        robot.converter.stop();
        robot.converter.start();
        robot.settle();
        assertThat(robot.waits).containsExactly(Visit.Beginning.NEW, Visit.Beginning.RESUMED, Visit.Beginning.RESUMED);
    }

    @Test
    void aViolationIsKept() throws Exception {
        robot.press("Clean");
        robot.settle();
        robot.converter.offer(new Occurrence.Violated("It rests", 0));
        robot.settle();
        robot.copyAndRevive();

        assertThat(robot.outcomes()).containsExactly("Clean HANDLED", "violation of It rests FAILED");
    }

    @Test
    void historyReachesAsFarBackAsTheJournal() throws Exception {
        for (int press = 0; press < 150; press++) {
            robot.press("Clean");
            robot.settle();
        }
        robot.copyAndRevive();
        robot.converter.start();
        for (int press = 0; press < 150; press++) {
            robot.press("Clean");
            robot.settle();
        }

        assertThat(robot.converter.history()).hasSize(200);
        List<HistoryEntry> all = robot.converter.history(1_000);
        assertThat(all.size()).isGreaterThanOrEqualTo(300);
        assertThat(all)
                .extracting(HistoryEntry::number)
                .isEqualTo(LongStream.rangeClosed(1, all.size()).boxed().toList());
        assertThat(robot.converter.history(5))
                .as("the same from memory as from the journal")
                .isEqualTo(all.subList(all.size() - 5, all.size()));
        assertThat(robot.converter.history(250)).isEqualTo(all.subList(all.size() - 250, all.size()));
        assertThatThrownBy(() -> robot.converter.history(0)).hasMessageContaining("1 to 100000 events, not 0");
    }

    @Test
    void historyReachesBackBeyondProcessesThatWereKilledAtOnce() throws Exception {
        robot.press("Clean");
        robot.settle();
        for (int life = 0; life < 3; life++) {
            robot.copyAndRevive();
        }

        assertThat(robot.outcomes()).containsExactly("Clean HANDLED");
    }

    @Test
    void aStepThatWasBeingSentIsInDoubtAndNotSentAgain() throws Exception {
        robot.meanwhile = robot::copy;
        robot.press("Clean");
        robot.settle();
        robot.revive(Duration.ZERO);

        assertThat(robot.converter.status().doubt()).isEqualTo("it is unknown whether Clean had its effect: " + ENDED);
        assertThat(robot.outcomes()).containsExactly("Clean FAILED");
        robot.answer = Optional.of("On");
        robot.converter.start();
        robot.settle();
        assertThat(robot.states()).isEqualTo("(On, On)");
        assertThat(robot.converter.status().doubt()).isEmpty();
        assertThat(robot.sent).containsExactly("Clean");
    }

    @Test
    void aDeviceThatCannotReportIsAssumedNotToHaveObeyed() throws Exception {
        robot.meanwhile = robot::copy;
        robot.press("Clean");
        robot.settle();
        robot.revive(Duration.ZERO);
        robot.converter.start();
        robot.settle();

        assertThat(robot.states()).isEqualTo("(Off, Off)");
        assertThat(robot.converter.status().doubt()).isNotEmpty();
        assertThat(robot.sent).containsExactly("Clean");
    }

    @Test
    void aPlanContinuesAfterTheStepThatWasSentAndAnEffectIsNotRunTwice() throws Exception {
        robot.press("Clean");
        robot.settle();
        robot.meanwhile = () -> {
            if (robot.done.contains("beep")) {
                robot.copy();
            }
        };
        robot.press("Clean");
        robot.settle();
        robot.revive(Duration.ZERO);

        assertThat(robot.states()).isEqualTo("(Clean, On)");
        robot.converter.start();
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, Clean)");
        assertThat(robot.sent).containsExactly("Clean", "Clean");
        assertThat(robot.done).containsExactly("beep");
        assertThat(robot.converter.history().get(1).detail())
                .isEqualTo("it is unknown whether the effect beep was run: " + ENDED);
    }

    @Test
    void timersKeepWhatIsLeftOfThem() throws Exception {
        waitForTheSpot();
        robot.clock.advance(Duration.ofSeconds(2));
        robot.copy();
        robot.revive(Duration.ofSeconds(3));
        robot.converter.start();

        robot.clock.advance(Duration.ofMillis(1_900));
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, SpotWait)");
        robot.clock.advance(Duration.ofMillis(100));
        robot.settle();
        assertThat(robot.states()).isEqualTo("(On, On)");
    }

    private void waitForTheSpot() throws InterruptedException {
        for (int press = 0; press < 3; press++) {
            robot.press("Clean");
        }
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, SpotWait)");
    }

    @Test
    void aTimerThatWasDueWhileNothingRanIsDueAtOnce() throws Exception {
        waitForTheSpot();
        robot.copy();
        robot.revive(Duration.ofMinutes(1));
        robot.converter.start();
        robot.clock.advance(Duration.ZERO);
        robot.settle();

        assertThat(robot.states()).isEqualTo("(On, On)");
    }

    @Test
    void aFunctionBeginsAnew() throws Exception {
        robot.press("Clean");
        robot.press("Spot");
        robot.settle();
        assertThat(robot.done).containsExactly("move");
        robot.copyAndRevive();
        assertThat(robot.done).containsExactly("move");

        robot.converter.start();
        assertThat(robot.done).containsExactly("move", "move");
    }

    @Test
    void aConverterThatWasStoppedIsStopped() throws Exception {
        robot.press("Clean");
        robot.settle();
        robot.converter.stop();
        robot.copyAndRevive();
        assertThat(robot.states()).isEqualTo("(On, On)");
        assertThatThrownBy(() -> robot.press("Clean")).hasMessageContaining("is stopped");

        robot.copyAndRevive();
        robot.converter.start();
        robot.press("Clean");
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, Clean)");
        assertThat(robot.converter.status().queue().refused()).isEqualTo(1);
    }

    @Test
    void aJournalComesBeforeBuilding() {
        assertThatThrownBy(() -> robot.converter.journal(Journal.in(directory)))
                .isInstanceOf(IllegalStateException.class)
                .hasMessage("converter robot has been built before");
    }

    @Test
    void modelsThatTookOverCountInTheNextProcessToo() throws Exception {
        robot.press("Clean");
        robot.press("Spot");
        robot.settle();
        robot.press("arriveSpot");
        robot.evolve(Robot.withoutSpotWait());
        robot.copyAndRevive();

        assertThat(robot.converter.knowledge().models().evolved().name()).isEqualTo("direct");
        assertThat(robot.states()).isEqualTo("(On, Move)");
        assertThat(robot.converter.status().evolution())
                .isEqualTo("'direct', which took over from 'new' before the program was started");
        robot.converter.start();
        robot.settle();
        assertThat(robot.states())
                .as("the event that waited during the evolution")
                .isEqualTo("(Spot, Spot)");
        robot.copyAndRevive();
        assertThat(robot.converter.knowledge().models().evolved().name()).isEqualTo("direct");
        assertThat(robot.converter.history(100))
                .extracting(entry -> entry.occurrence().label())
                .containsExactly("Clean", "Spot", "arriveSpot");
        assertThat(robot.swaps()).containsExactly("[(On, Move), 'direct' took over from 'new']");

        assertThat(robot.converter.rollBack().model()).isEqualTo("new");
        assertThat(robot.states()).isEqualTo("(Spot, Spot)");
        assertThatThrownBy(robot.converter::rollBack).hasMessageContaining("nothing to roll back to");
        robot.copyAndRevive();
        assertThat(robot.converter.knowledge().models().evolved().name()).isEqualTo("new");
        assertThat(robot.states()).isEqualTo("(Spot, Spot)");
    }

    @Test
    void noFunctionRunsWhileTheDeviceIsSentToOtherModelsStateEvenAfterACrash() throws Exception {
        robot.press("Clean");
        robot.press("Spot");
        robot.settle();
        assertThat(robot.done).containsExactly("move");
        robot.evolve(Robot.movingInClean());
        robot.copyAndRevive();
        robot.meanwhile = () -> robot.done.add("driven");
        robot.converter.start();
        robot.settle();
        assertThat(robot.states()).isEqualTo("(Clean, Move)");
        assertThat(robot.sent).containsExactly("Clean", "Clean");
        assertThat(robot.done).containsExactly("move", "driven", "move");
    }

    @Test
    void modelsWithoutAKnowledgeFactoryAreNamed() {
        robot.evolve(Robot.withoutSpotWait());
        robot.copy();
        robot.evolving = false;
        assertThatThrownBy(() -> robot.revive(Duration.ZERO))
                .hasMessage("there is no knowledge factory for the models 'original' and 'direct'; call "
                        + "addKnowledgeFactory");
        robot.evolving = true;
        robot.copyAndRevive();
    }

    @Test
    void aJournalThatCannotBeWrittenKeepsOtherModelsOut() throws Exception {
        robot.press("Clean");
        robot.settle();
        robot.blockJournal();
        assertThatThrownBy(() -> robot.evolve(Robot.withoutSpotWait()))
                .hasMessageContaining("life0 cannot be written: ");
        assertThat(robot.converter.knowledge().models()).isSameAs(Robot.MODELS);
        robot.unblockJournal();
        robot.press("Spot");
        robot.settle();
        assertThat(robot.states())
                .as("the journal of the models that remain is written")
                .isEqualTo("(On, Move)");
        robot.copyAndRevive();
        assertThat(robot.states()).isEqualTo("(On, Move)");
    }
}
