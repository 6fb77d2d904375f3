#!/bin/sh
# What the person at the stick sees: the window, and behind it the projects, printers and the switch.
kernel_option() { sed -n "s/.*ostraka\.$1=\([^ ]*\).*/\1/p" /proc/cmdline; }
LANG=$(kernel_option language).UTF-8
export LANG
layout=$(kernel_option keyboard)
setxkbmap -layout "${layout:-us}" -option grp:alt_shift_toggle
xset s off -dpms  # a long day of photographs is no reason to turn the screen off

without_projects() {
  case "$LANG" in
    de*) echo 'Der Platz für Projekte auf diesem Stick ließ sich nicht öffnen.
Was Sie jetzt speichern, geht beim Ausschalten verloren.
Weiter mit der Eingabetaste.' ;;
    fr*) echo "L'espace des projets sur cette clé n'a pas pu être ouvert.
Ce que vous enregistrez maintenant sera perdu à l'arrêt de l'ordinateur.
Appuyez sur Entrée pour continuer." ;;
    es*) echo 'No se pudo abrir el espacio para proyectos de esta memoria USB.
Lo que guarde ahora se perderá al apagar el equipo.
Pulse Intro para continuar.' ;;
    el*) echo 'Ο χώρος για τα έργα σε αυτό το στικ δεν άνοιξε.
Ό,τι αποθηκεύσετε τώρα θα χαθεί όταν κλείσει ο υπολογιστής.
Πατήστε Enter για συνέχεια.' ;;
    tr*) echo 'Bu bellekteki proje alanı açılamadı.
Şimdi kaydettikleriniz bilgisayar kapatılınca kaybolur.
Devam etmek için Enter tuşuna basın.' ;;
    hy*) echo 'Այս կրիչի նախագծերի տարածքը չհաջողվեց բացել։
Այն, ինչ հիմա պահեք, կկորչի համակարգիչն անջատելիս։
Շարունակելու համար սեղմեք Enter։' ;;
    *) echo 'The space for projects on this stick could not be opened.
What you save now is lost when the computer is switched off.
Press Enter to go on.' ;;
  esac
}

lxpolkit &
pcmanfm --desktop &
(
  # The window would cover the message, so it waits until that was read.
  # shellcheck disable=SC2016  # for the inner shell
  mountpoint -q /projects || xterm -T Ostraka -fa Monospace -fs 14 -e sh -c 'echo "$0"; read -r answer' \
    "$(without_projects)"
  cd /projects && exec ostraka
) &
exec openbox
