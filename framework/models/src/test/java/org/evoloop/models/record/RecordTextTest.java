package org.evoloop.models.record;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.engine.Input;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Values;
import org.evoloop.journal.DryRun;
import org.evoloop.journal.JournalRecord;
import org.evoloop.rehearsal.Difference;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.statemachine.StateMachine;
import org.junit.jupiter.api.Test;

/** A line for each kind of record. */
class RecordTextTest {
    private static final Configuration ON = new Configuration(new State("On"), new State("Move"));

    private static String line(Input input) {
        return line(input, "", List.of());
    }

    private static String line(Input input, String doubt, List<String> endings) {
        String whole = RecordText.line(
                new JournalRecord("1.journal", 1, 40, Instant.EPOCH, 1_500_000_000, "kind", input, ON, doubt, endings),
                ZoneOffset.UTC);
        assertThat(whole).startsWith("1970-01-01 00:00:00.000000        1.500000  kind      ");
        return whole.substring("1970-01-01 00:00:00.000000        1.500000  kind      ".length())
                .strip();
    }

    @Test
    void printsTheConvertersInputs() {
        assertThat(line(new Input.Opened(1))).isEqualTo("at (On, Move)");
        assertThat(line(new Input.TimerDue(3, new Event("timeout"), 1))).isEqualTo("timeout, visit 3  at (On, Move)");
        assertThat(line(new Input.Dismissed(7, 1))).startsWith("#7  at");
        assertThat(line(new Input.Sending(7))).startsWith("#7  at");
        assertThat(line(new Input.Sent(7, true, 1))).startsWith("#7  at");
        assertThat(line(new Input.Running(7))).startsWith("#7  at");
        assertThat(line(new Input.EffectRun(7, "", 1))).startsWith("#7  at");
        assertThat(line(new Input.EffectRun(7, "no\npaper", 1))).startsWith("#7 failed: no?paper  at");
        assertThat(line(new Input.Located(7, new State("Off"), 1))).startsWith("#7 Off  at");
        assertThat(line(new Input.Located(7, null, 1))).startsWith("#7 cannot be told  at");
        assertThat(line(new Input.Failed(7, "unplugged", 1))).startsWith("#7 unplugged  at");
        assertThat(line(new Input.GivenUp(7, "it hangs", 1))).startsWith("#7 it hangs  at");
        assertThat(line(new Input.Planned(7, new Decision.Refused(ON, "child lock"), 1)))
                .startsWith("#7 refused (On, Move) -> (On, Move): child lock  at");
        assertThat(line(new Input.Observed(new Occurrence.Found(new State("Off"), 1))))
                .contains("Off");
        assertThat(line(new Input.Observed(new Occurrence.Asked(new Event("go"), Values.of("speed", 2), 0, 1))))
                .contains("go (speed=2)");
    }

    @Test
    void endsWithEndingsAndDoubts() {
        assertThat(line(new Input.Sent(7, true, 1), "nobody knows", List.of("Clean handled: Clean", "Spot stale")))
                .isEqualTo("#7  at (On, Move)  | Clean handled: Clean  | Spot stale  IN DOUBT: nobody knows");
    }

    @Test
    void noNameForgesALine() {
        Occurrence odd = new Occurrence.Found(new State("Off\n1970\u2028x\u001b[2J"), 1);

        assertThat(line(new Input.Observed(odd))).startsWith("found Off?1970?x?[2J  at");
        assertThat(ReplayText.write(
                        new DryRun.Result(
                                1,
                                List.of(new Difference(Instant.EPOCH, odd, null, null)),
                                List.of(),
                                List.of(),
                                List.of()),
                        PropertyFile.parse("F", "", new ModelPair(lamp(), lamp())),
                        ZoneOffset.UTC))
                .startsWith("1970-01-01 00:00:00.000000  found Off?1970?x?[2J\n  then  ");
    }

    private static StateMachine lamp() {
        return StateMachine.named("lamp").initial("Off").build();
    }
}
