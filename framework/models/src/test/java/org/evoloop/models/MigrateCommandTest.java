package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** The migration plan on the command line, for the Roomba's evolutions. */
class MigrateCommandTest {
    private static final String ROOMBA =
            Path.of(System.getProperty("evoloop.root"), "models", "roomba.xml").toString();
    private static final String HOME = ROOMBA + "#home";
    private static final String GUEST = ROOMBA + "#guest";
    private static final String DEVICE = ROOMBA + "#original";

    @TempDir
    private Path directory;

    private String mapping(String text) throws IOException {
        return Files.writeString(directory.resolve("mapping.txt"), text).toString();
    }

    private static Tool migrate(String from, String to, String... more) {
        String[] arguments = new String[5 + more.length];
        System.arraycopy(new String[] {"migrate", from, to, "--original", DEVICE}, 0, arguments, 0, 5);
        System.arraycopy(more, 0, arguments, 5, more.length);
        return Tool.run(arguments);
    }

    @Test
    void anEqualModelMapsEveryPairToItself() {
        Tool equal = migrate(HOME, HOME);
        assertThat(equal.status()).isZero();
        assertThat(equal.err()).isEmpty();
        assertThat(equal.out())
                .contains("(On, Move)  maps to (On, Move): function Move kept\n")
                .contains("54 pairs of states: 54 map, 0 by sending, 0 wait, 0 impossible")
                .doesNotContain("waiting, because");
    }

    @Test
    void whatTheNextModelLacksWaitsOrGoesWhereTheMappingSays() throws IOException {
        Tool byName = migrate(HOME, GUEST);
        assertThat(byName.status()).isZero();
        assertThat(byName.out())
                .contains("from home (17 states")
                .contains("(Clean, SpotWait)  waits until tm(5s) or Clean or Dock leads out; may never come: Clean, "
                        + "Dock\n")
                .containsOnlyOnce("no state SpotWait; map it: state SpotWait -> STATE");

        Tool mapped = migrate(HOME, GUEST, "--mapping", mapping("state SpotWait -> Dock\n"));
        assertThat(mapped.out())
                .contains("(Clean, SpotWait)  by sending Clean, Dock to (Dock, Dock): timer tm(5s) ended, function");
    }

    @Test
    void anImpossibleSwapIsReportedByTheStatus() {
        Tool deaf = migrate(HOME, GUEST, "--sendable", "Dock", "--mapping", trap());
        assertThat(deaf.status()).isEqualTo(1);
        assertThat(deaf.out()).contains("IMPOSSIBLE, because the new model is in Off, but with the device in ");
    }

    private String trap() {
        try {
            return mapping(
                    "state Charging -> Off\nstate Charged -> Off\nstate On -> Off\nstate Off -> Off\nstate Dock -> "
                            + "Off\n"
                            + "state Asleep -> Off\nstate Error -> Off\nstate Clean -> Off\nstate Max -> Off\nstate "
                            + "Spot -> Off\n");
        } catch (IOException unexpected) {
            throw new AssertionError(unexpected);
        }
    }

    @Test
    void programsReadIt() {
        JsonNode plan = new JsonMapper()
                .readTree(migrate(HOME, GUEST, "--format", "json").out());
        assertThat(plan.path("possible").asBoolean()).isTrue();
        assertThat(plan.path("from").path("new").asString()).isEqualTo("home");
        JsonNode waits = null;
        for (JsonNode pair : plan.path("pairs")) {
            boolean wanted = pair.path("newState").asString().equals("SpotWait")
                    && pair.path("originalState").asString().equals("Clean");
            waits = wanted ? pair : waits;
        }
        assertThat(waits).isNotNull();
        assertThat(waits.path("kind").asString()).isEqualTo("waits");
        assertThat(waits.path("exits").get(0).asString()).isEqualTo("tm(5s)");
        assertThat(waits.path("toNewState").isNull()).isTrue();
    }

    @Test
    void thePictureShowsWhatBecomesOfEachState() {
        assertThat(migrate(HOME, GUEST, "--format", "svg").out())
                .startsWith("<svg")
                .contains("home \u2192 guest", "the swap waits until it is left", "waits for tm(5s)");
    }

    @Test
    void mistakesAreNamed() throws IOException {
        assertRefused(Tool.run("migrate", HOME, GUEST), "--original");
        assertRefused(migrate(HOME, ROOMBA + "#visitor"), "'visitor'", "'guest'");
        assertRefused(migrate(HOME, GUEST, "--mapping", "nowhere.txt"), "nowhere.txt: does not exist");
        assertRefused(
                migrate(HOME, GUEST, "--mapping", mapping("state Spotwait -> On\n")),
                "mapping.txt, line 1: 'Spotwait' is no state of the running new model");
        assertRefused(migrate(HOME, GUEST, "--sendable", "Fly"), "--sendable", "Fly");
    }

    private static void assertRefused(Tool refused, String... words) {
        assertThat(refused.status()).isEqualTo(2);
        assertThat(refused.out()).isEmpty();
        assertThat(refused.err()).startsWith("error: ").contains(words).doesNotContain("\tat ");
    }
}
