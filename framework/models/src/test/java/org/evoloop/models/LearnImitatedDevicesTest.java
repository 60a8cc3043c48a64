package org.evoloop.models;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import org.evoloop.device.DeviceFile;
import org.evoloop.device.DeviceProgram;
import org.evoloop.device.ImitatedDevice;
import org.evoloop.imitation.Faults;
import org.evoloop.imitation.Imitation;
import org.evoloop.mqtt.Mosquitto;
import org.evoloop.statemachine.StateMachine;
import org.evoloop.xmi.ModelReference;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import picocli.CommandLine;

/** The devices of {@code devices} are learned from their files: what is found is what their READMEs draw. */
class LearnImitatedDevicesTest {
    private static final Path DEVICES = Path.of(System.getProperty("evoloop.root", "../.."), "devices");

    @TempDir
    private Path folder;

    private final StringWriter out = new StringWriter();

    @Test
    void aBulbIsWhatItsReadmeDraws() throws Exception {
        isWhatItsReadmeDraws(ImitatedDevice.ZIGBEE_BULB);
    }

    @ParameterizedTest
    @EnumSource(names = {"AIR_CONDITIONER", "OCTOPRINT"})
    @Tag("slow")
    void largerOnesAreWhatTheirReadmesDraw(ImitatedDevice device) throws Exception {
        isWhatItsReadmeDraws(device);
    }

    private void isWhatItsReadmeDraws(ImitatedDevice device) throws Exception {
        Path original = DEVICES.resolve(device.folder()).resolve(device.folder() + ".yaml");
        StateMachine drawn =
                DeviceFile.read(original, DeviceProgram.options()).models().original();
        Path learned = folder.resolve("learned.mmd");
        try (Mosquitto broker = new Mosquitto(folder).start();
                Imitation imitation = new Imitation(drawn, Faults.NONE, 1);
                ImitatedDevice.Running running = device.imitate(folder, broker, imitation)) {
            Files.writeString(folder.resolve("README.md"), Files.readString(original.resolveSibling("README.md")));
            Path file = Files.writeString(
                    folder.resolve("device.yaml"),
                    running.in(Files.readString(original)).replaceFirst("settle: [0-9]+ s", "settle: 150 ms"));
            CommandLine command = Main.learning();
            command.setOut(new PrintWriter(out, true));
            assertThat(Main.run(command, file.toString(), "--output=" + learned, "--longest=200 ms"))
                    .as(out.toString())
                    .isZero();
            assertThat(imitation.truth()).isEqualTo(drawn.initial().name());
        }
        assertThat(pressed(ModelReference.parse(learned + "#original").load()))
                .as(out.toString())
                .isEqualTo(pressed(drawn));
    }

    /** Its transitions but those that the device takes by itself, which an imitation does only when it is told to. */
    private static Set<String> pressed(StateMachine machine) {
        return machine.transitions().stream()
                .filter(transition -> !machine.spontaneous().contains(transition.event()))
                .map(transition ->
                        transition.source() + " " + transition.event().trigger() + " " + transition.target())
                .collect(Collectors.toSet());
    }
}
