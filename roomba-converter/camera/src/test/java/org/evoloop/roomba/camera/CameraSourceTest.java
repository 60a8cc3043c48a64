package org.evoloop.roomba.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.evoloop.roomba.camera.CameraSource.Kind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CameraSourceTest {
    @ParameterizedTest
    @CsvSource({
        "0, DEVICE, /dev/video0",
        "12, DEVICE, /dev/video12",
        "/dev/v4l/by-id/usb-cam, DEVICE, /dev/v4l/by-id/usb-cam",
        "http://127.0.0.1:8090/, URL, http://127.0.0.1:8090/",
        "HTTPS://camera/x, URL, HTTPS://camera/x",
        "film.avi, FILE, film.avi",
        "frames/%04d.png, IMAGE_SEQUENCE, frames/%04d.png",
        "frames/%d.jpg, IMAGE_SEQUENCE, frames/%d.jpg",
        "100%.avi, FILE, 100%.avi",
        "sim, SIMULATED, sim",
    })
    void knowsAllKinds(String text, Kind kind, String meant) {
        CameraSource source = CameraSource.parse(text);
        assertThat(source).isEqualTo(new CameraSource(kind, meant));
        assertThat(source.isLive()).isEqualTo(kind == Kind.DEVICE || kind == Kind.URL || kind == Kind.SIMULATED);
    }

    @Test
    void refusesOtherProtocolsAndNothing() {
        assertThatThrownBy(() -> CameraSource.parse("ftp://x"))
                .isInstanceOf(CameraException.class)
                .hasMessageStartingWith("camera ftp://x: ftp is not supported; ");
        assertThatThrownBy(() -> CameraSource.parse(" "))
                .isInstanceOf(CameraException.class)
                .hasMessageStartingWith("the camera has no name; ");
    }

    @ParameterizedTest
    @CsvSource({
        "http://me:secret@camera/stream, http://***@camera/stream",
        "http://me:sec/ret@camera, http://***@camera",
        "http://camera:81/video?user=me&pwd=secret, http://camera:81/video?***",
        "http://camera/stream, http://camera/stream",
        "film@home.avi, film@home.avi",
    })
    void aPasswordIsInNoMessage(String text, String shown) {
        assertThat(CameraSource.parse(text)).hasToString(shown);
    }

    @Test
    void aRefusedAddressShowsNoPasswordEither() {
        assertThatThrownBy(() -> CameraSource.parse("rtsp://me:secret@camera"))
                .hasMessageStartingWith("camera rtsp://***@camera: rtsp is not supported; ")
                .hasMessageNotContaining("secret");
    }

    @Test
    void reportsWhatIsInTheWay() {
        assertThat(CameraSource.parse("/nowhere.avi").obstacle()).hasValue("does not exist; correct the path");
        assertThat(CameraSource.parse("/").obstacle()).hasValue("is a folder; name a file in it");
        assertThat(CameraSource.parse("http://x/").obstacle()).isEmpty();
    }
}
