package org.evoloop.check.temporal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import org.evoloop.check.CheckInput;
import org.evoloop.check.properties.PropertyFile;
import org.evoloop.check.temporal.PropertyWatch.Standing;
import org.evoloop.evolution.Configuration;
import org.evoloop.evolution.Decision;
import org.evoloop.evolution.DecisionTable;
import org.evoloop.evolution.ModelPair;
import org.evoloop.evolution.Occurrence;
import org.evoloop.evolution.Outcome;
import org.evoloop.evolution.Source;
import org.evoloop.evolution.Values;
import org.evoloop.statemachine.Event;
import org.evoloop.statemachine.State;
import org.evoloop.xmi.ModelFile;
import org.junit.jupiter.api.Test;

/** Properties watched while the cleaning robot receives events. */
class PropertyWatchTest {
    private static final ModelPair ROBOT = robot();
    private static final DecisionTable TABLE = DecisionTable.compile(
            ROBOT, CheckInput.of(ROBOT).withOwnEvents(Set.of("endSpot")).device());

    private static ModelPair robot() {
        ModelFile file = ModelFile.read(Path.of(System.getProperty("evoloop.root"), "models", "cleaning-robot.xml"));
        return new ModelPair(file.pick("original"), file.pick("new"));
    }

    private static Configuration at(String original, String evolved) {
        return new Configuration(new State(original), new State(evolved));
    }

    private static PropertyWatch watch(Configuration from, String... formulas) {
        PropertyFile file = PropertyFile.parse("robot.properties.txt", String.join("\n", formulas), ROBOT);
        return new PropertyWatch(file.properties(), TABLE, from);
    }

    private static Standing standing(PropertyWatch watch) {
        return watch.standing(watch.properties().get(0));
    }

    /** Plays the events in turn as the robot's converter decides them; returns what broke, and on which event. */
    private static List<String> play(PropertyWatch watch, Configuration from, String... events) {
        Configuration at = from;
        for (String event : events) {
            Decision decision = TABLE.decide(at, new Event(event), false);
            at = decision.after();
            List<Property> broken = watch.ended(heard(event), at, Outcome.HANDLED, decision);
            if (!broken.isEmpty()) {
                return broken.stream()
                        .map(property -> property.name() + " by " + event)
                        .toList();
            }
        }
        return List.of();
    }

    private static Occurrence heard(String event) {
        return new Occurrence.Heard(new Event(event), Values.NONE, Source.CONTROLLER, Occurrence.ANY_VISIT, 1);
    }

    @Test
    void whatMustNeverBeIsBrokenByTheFirstEventThatLeadsThere() {
        PropertyWatch watch = watch(ROBOT.initial(), "a: never SpotWait", "b: never Move", "off trap-state On: none");
        assertThat(play(watch, ROBOT.initial(), "Clean", "Clean")).isEmpty();
        assertThat(play(watch, at("Clean", "Clean"), "Clean", "timeout")).containsExactly("a by Clean");
        assertThat(watch.broken()).extracting(Property::name).containsExactly("a");
        assertThat(play(watch, at("On", "On"), "Spot"))
                .as("another property is still watched")
                .containsExactly("b by Spot");
    }

    @Test
    void whatMustComeIsOpenUntilItComes() {
        PropertyWatch watch = watch(ROBOT.initial(), "always (Move implies eventually Spot)");
        play(watch, ROBOT.initial(), "Clean");
        assertThat(standing(watch)).isEqualTo(Standing.KEPT);
        play(watch, at("On", "On"), "Spot");
        assertThat(standing(watch)).isEqualTo(Standing.OPEN);
        play(watch, at("On", "Move"), "arriveSpot");
        assertThat(standing(watch)).isEqualTo(Standing.KEPT);
        PropertyWatch until = watch(ROBOT.initial(), "Off until On");
        assertThat(standing(until)).isEqualTo(Standing.OPEN);
        until.happened(at("Clean", "Clean"), new Event("Clean"));
        assertThat(standing(until)).isEqualTo(Standing.BROKEN);
    }

    @Test
    void whatCanHappenTheModelsSay() {
        assertThat(play(
                        watch(ROBOT.initial(), "always (Spot implies can Off)"),
                        ROBOT.initial(),
                        "Clean",
                        "Spot",
                        "arriveSpot"))
                .containsExactly("always (Spot implies can Off) by arriveSpot");
        assertThat(watch(at("Spot", "Move"), "can Spot", "always can On").broken())
                .as("a situation that events cannot lead to if nothing fails")
                .isEmpty();
    }

    @Test
    void whatCameBeforeTheBeginningBreaksNothing() {
        PropertyWatch watch =
                watch(at("Spot", "Spot"), "never Move", "Spot only after event Spot", "Spot only after Off");
        assertThat(watch.broken()).isEmpty();
        assertThat(watch(at("Spot", "Spot"), "never Spot").broken()).hasSize(1);
    }

    @Test
    void anEventThatComesToNothingHasNotHappened() {
        PropertyWatch watch = watch(ROBOT.initial(), "never event Spot", "next On");
        for (Outcome outcome : List.of(Outcome.IGNORED, Outcome.STALE, Outcome.DROPPED, Outcome.FAILED)) {
            assertThat(watch.ended(heard("Spot"), ROBOT.initial(), outcome, null))
                    .isEmpty();
        }
        Occurrence found = new Occurrence.Found(new State("On"), 1);
        assertThat(watch.ended(found, at("On", "On"), Outcome.HANDLED, null)).isEmpty();
        assertThat(watch.ended(heard("Spot"), at("On", "Move"), Outcome.FAILED, null))
                .as("it has moved all the same")
                .extracting(Property::name)
                .containsExactly("never event Spot");
    }

    @Test
    void everyWayToKeepAPropertyIsFollowed() {
        PropertyWatch watch = watch(
                ROBOT.initial(),
                "always (not Clean or next SpotWait)",
                "(Off until On) and (Off unless On)",
                "never (SpotWait and can Move)",
                "eventually (Clean and next Off)",
                "(always Off) or (eventually Move)");
        assertThat(play(watch, ROBOT.initial(), "Clean", "Clean")).isEmpty();
        assertThat(watch.properties())
                .extracting(watch::standing)
                .containsExactly(Standing.OPEN, Standing.KEPT, Standing.KEPT, Standing.OPEN, Standing.OPEN);
        watch.happened(at("Clean", "SpotWait"), new Event("Clean"));
        assertThat(watch.properties())
                .extracting(watch::standing)
                .containsExactly(Standing.KEPT, Standing.KEPT, Standing.BROKEN, Standing.OPEN, Standing.OPEN);
        watch.happened(at("Clean", "Clean"), null);
        assertThat(watch.happened(at("On", "On"), null))
                .extracting(Property::name)
                .containsExactly("always (not Clean or next SpotWait)");
    }

    @Test
    void whatIsNotWatchedHasNoStanding() {
        Property other = new Property("other", new Formula.Constant(true), 1);
        assertThatThrownBy(() -> watch(ROBOT.initial()).standing(other))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("'other' is not watched");
    }
}
